// What shared/math/elementary.hpp declares, of 113 bits. Only the reference has it: shots that
// machines have to agree on take no function of a C library.

#include "shared/math/elementary.hpp"

namespace poolhall {

// glibc's functions of binary128, by their symbols (real_113.hpp).
namespace glibc {
Real exp(Real x) __asm__("expf128");
Real expm1(Real x) __asm__("expm1f128");
Real log(Real x) __asm__("logf128");
Real log1p(Real x) __asm__("log1pf128");
}  // namespace glibc

namespace elementary {

Real exp(Real x) {
    return glibc::exp(x);
}

Real expm1(Real x) {
    return glibc::expm1(x);
}

Real log(Real x) {
    return glibc::log(x);
}

Real log1p(Real x) {
    return glibc::log1p(x);
}

}  // namespace elementary

}  // namespace poolhall
