#include "client/lab/input/solver_option.hpp"

#include "shared/enum_names.hpp"
#include "shared/physics/simulate.hpp"

#include <charconv>
#include <system_error>

namespace poolhall::lab {

std::optional<SolverSpec> parse_solver(std::string_view text) {
    const std::size_t colon = text.find(':');
    const auto kind = find<SolverKind>(text.substr(0, colon));
    if (!kind) return std::nullopt;
    SolverSpec spec{*kind, SolverSpec{}.hz};
    if (colon == std::string_view::npos) return spec;
    const std::string_view hz = text.substr(colon + 1);
    const char* const end = hz.data() + hz.size();
    const auto [stop, error] = std::from_chars(hz.data(), end, spec.hz);
    const bool good =
        error == std::errc{} && stop == end && spec.hz >= kMinSolverHz && spec.hz <= kMaxSolverHz;
    if (!good || !has_ticks(*kind)) return std::nullopt;
    return spec;
}

}  // namespace poolhall::lab
