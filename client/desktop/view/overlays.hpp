#pragma once

#include "client/desktop/render/mesh.hpp"
#include "client/desktop/view/layout.hpp"
#include "client/play/view_state.hpp"

// What lies on the cloth beside the balls, as shapes.
namespace poolhall::client {

/// Width of a thin line, px: visible on a small window, and not fat on a large one.
[[nodiscard]] float hair(const Layout& layout);

/// Where the cue ball in hand may be put: a line, or the outline of a rectangle.
void add_placement(Mesh& mesh, const Layout& layout, const Region& region);
void add_ball_shadow(Mesh& mesh, const Layout& layout, Vec2 r);
void add_trail(Mesh& mesh, const Layout& layout, const ViewState& state);
/// Arrow, ghost ball and predicted paths.
void add_aim(Mesh& mesh, const Layout& layout, const AimView& aim);
void add_collision_marks(Mesh& mesh, const Layout& layout, const std::vector<CollisionMark>& marks);
/// Footprints for step mode and a small black circle for collision mode, on the frame's lower left.
void add_mode_icons(Mesh& mesh, const Layout& layout, const ViewState& state);

/// Length of the aim arrow from the cue ball's centre, in ball radii.
inline constexpr float kArrowLength = 5.5F;

}  // namespace poolhall::client
