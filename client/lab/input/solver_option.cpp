#include "client/lab/input/solver_option.hpp"

#include "protocol/wire/enums.hpp"

#include <charconv>
#include <system_error>

namespace poolhall::lab {

namespace {

std::optional<SolverKind> kind_of(std::string_view text) {
    const auto last = static_cast<unsigned>(protocol::wire::kLast<SolverKind>);
    for (unsigned i = 0; i <= last; ++i) {
        if (name(static_cast<SolverKind>(i)) == text) return static_cast<SolverKind>(i);
    }
    return std::nullopt;
}

}  // namespace

std::optional<SolverSpec> parse_solver(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto kind = kind_of(text.substr(0, colon));
    if (!kind) return std::nullopt;
    SolverSpec spec{*kind, SolverSpec{}.hz};
    if (colon == std::string_view::npos) return spec;
    const std::string_view hz = text.substr(colon + 1);
    const char* const end = hz.data() + hz.size();
    const auto [stop, error] = std::from_chars(hz.data(), end, spec.hz);
    const bool good =
        error == std::errc{} && stop == end && spec.hz >= kMinSolverHz && spec.hz <= kMaxSolverHz;
    if (!good || *kind == SolverKind::kEvent) return std::nullopt;
    return spec;
}

}  // namespace poolhall::lab
