#pragma once

#include "client/desktop/render/text.hpp"
#include "client/desktop/view/layout.hpp"
#include "client/play/view_state.hpp"

#include <span>

// The same shot by several solvers: a colour and a width for each, the first the widest and lowest,
// so that ways that are the same show as stripes.
namespace poolhall::client {

[[nodiscard]] SDL_Color solver_colour(std::size_t solver);

/// The way of every ball by every solver, as lines on the cloth.
void add_solver_paths(Mesh& mesh, const Layout& layout, std::span<const SolverView> solvers);
/// A ring where each solver has each ball now.
void add_solver_ghosts(Mesh& mesh, const Layout& layout, std::span<const SolverView> solvers);

/// Where a legend of that size (px) hides no ball, if there is such a place, and the least of the
/// paths: at the N or S rail.
[[nodiscard]] SDL_FRect legend_box(const Layout& layout, std::span<const SolverView> solvers,
                                   SDL_FPoint size);
/// Who is who, what each costs and how far off it ends.
void draw_solver_legend(Canvas& canvas, Text& text, const Layout& layout,
                        std::span<const SolverView> solvers);

}  // namespace poolhall::client
