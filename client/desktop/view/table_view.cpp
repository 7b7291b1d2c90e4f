#include "client/desktop/view/table_view.hpp"

#include "client/desktop/render/colour.hpp"
#include "client/desktop/view/ball_art.hpp"
#include "client/desktop/view/ball_spin.hpp"
#include "client/desktop/view/hud.hpp"
#include "client/desktop/view/overlays.hpp"
#include "client/desktop/view/panels.hpp"
#include "client/desktop/view/pocket_holes.hpp"
#include "client/desktop/view/solver_paths.hpp"
#include "client/desktop/view/table_art.hpp"
#include "client/desktop/view/table_painter.hpp"

#include <algorithm>
#include <limits>

namespace poolhall::client {
namespace {

constexpr float kSunkSize = 0.9F;
constexpr double kJump = 0.25;  // of the table's length: further in one picture is no rolling

// A sunk ball lies in the middle of the pocket that took it.
Vec2 resting_place(const ViewState& state, Vec2 r) {
    Vec2 nearest = r;
    double least = std::numeric_limits<double>::infinity();
    for (const PocketHole& hole : pocket_holes(state.table, state.ball_radius)) {
        const double distance = norm(hole.centre - r);
        if (distance < least) {
            least = distance;
            nearest = hole.centre;
        }
    }
    return nearest;
}

}  // namespace

struct TableView::Parts {
    void draw_cloth_shapes(Mesh& shapes, const ViewState& state) const;
    void draw_balls(Canvas& canvas, const ViewState& state);

    Layout layout;
    TableArt table_art;
    BallArt ball_art;
    BallSpin spin;
};

void TableView::Parts::draw_cloth_shapes(Mesh& shapes, const ViewState& state) const {
    if (state.placement) add_placement(shapes, layout, *state.placement);
    add_solver_paths(shapes, layout, state.solvers);
    add_trail(shapes, layout, state);
    for (const BallView& ball : state.balls) {
        if (!ball.sunk) add_ball_shadow(shapes, layout, ball.r);
    }
    if (state.aim) add_aim(shapes, layout, *state.aim);
}

void TableView::Parts::draw_balls(Canvas& canvas, const ViewState& state) {
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const BallView& ball = state.balls[i];
        const Vec2 r = ball.sunk ? resting_place(state, ball.r) : ball.r;
        const Orientation& lie =
            spin.follow(ball.id, r, state.ball_radius, kJump * state.table.length);
        const float radius = ball.sunk ? kSunkSize * layout.ball : layout.ball;
        ball_art.draw(canvas, i, layout.to_pixels(r),
                      {look_of(ball.id), lie, radius, {0, 0}, ball.sunk});
    }
}

TableView::TableView() : parts_(std::make_unique<Parts>()) {}

TableView::~TableView() = default;

void TableView::draw(DrawingSurface& surface, const ViewState& state, double now_s) {
    auto& [canvas, text] = surface;
    Layout& layout = parts_->layout;
    layout = layout_of(state.table, state.ball_radius, canvas.width(), canvas.height());
    parts_->table_art.draw(canvas, state.table, layout, now_s);
    parts_->draw_cloth_shapes(canvas.shapes(), state);
    parts_->draw_balls(canvas, state);
    add_solver_ghosts(canvas.shapes(), layout, state.solvers);
    add_collision_marks(canvas.shapes(), layout, state.marks);
    add_mode_icons(canvas.shapes(), layout, state);
    draw_top_bar(canvas, text, layout, state.match);
    draw_bottom_lines(canvas, text, layout, state);
    draw_solver_legend(canvas, text, layout, state.solvers);
    if (state.banner) draw_banner(canvas, text, layout, *state.banner);
}

void TableView::reset() {
    parts_->table_art.reset();
    parts_->ball_art.reset();
}

Vec2 TableView::to_table(SDL_FPoint pixel) const {
    return parts_->layout.to_table(pixel);
}

SDL_FPoint TableView::to_pixels(Vec2 table) const {
    return parts_->layout.to_pixels(table);
}

}  // namespace poolhall::client
