#include "client/desktop/view/table_view.hpp"

#include "client/desktop/render/canvas.hpp"
#include "client/desktop/render/colour.hpp"
#include "client/desktop/render/text.hpp"
#include "client/desktop/view/ball_art.hpp"
#include "client/desktop/view/ball_spin.hpp"
#include "client/desktop/view/hud.hpp"
#include "client/desktop/view/overlays.hpp"
#include "client/desktop/view/panels.hpp"
#include "client/desktop/view/solver_paths.hpp"
#include "client/desktop/view/table_art.hpp"
#include "client/desktop/view/table_painter.hpp"
#include "shared/table/pockets.hpp"

#include <algorithm>
#include <limits>

namespace poolhall::client {
namespace {

constexpr float kSunkSize = 0.9F;
constexpr double kJump = 0.25;  // of the table's length: further in one picture is no rolling

// A sunk ball lies in the middle of the pocket that took it.
Vec2 resting_place(const Table& table, Vec2 r) {
    if (table.pockets != PocketModel::kEndGame) return r;
    Vec2 nearest = r;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kPocketCount; ++i) {
        const Vec2 mouth = EndGamePocketMap::mouth(table, static_cast<Pocket>(i));
        const double distance = norm(mouth - r);
        if (distance < least) {
            least = distance;
            nearest = mouth;
        }
    }
    return nearest;
}

}  // namespace

struct TableView::Parts {
    explicit Parts(SDL_Renderer* renderer) : canvas(renderer), text(canvas) {}

    void draw_cloth_shapes(const ViewState& state);
    void draw_balls(const ViewState& state);
    void reset();

    Canvas canvas;
    Text text;
    Layout layout;
    TableArt table_art;
    BallArt ball_art;
    BallSpin spin;
};

void TableView::Parts::draw_cloth_shapes(const ViewState& state) {
    Mesh& shapes = canvas.shapes();
    if (state.placement) add_placement(shapes, layout, *state.placement);
    add_solver_paths(shapes, layout, state.solvers);
    add_trail(shapes, layout, state);
    for (const BallView& ball : state.balls) {
        if (!ball.sunk) add_ball_shadow(shapes, layout, ball.r);
    }
    if (state.aim) add_aim(shapes, layout, *state.aim);
}

void TableView::Parts::draw_balls(const ViewState& state) {
    for (std::size_t i = 0; i < state.balls.size(); ++i) {
        const BallView& ball = state.balls[i];
        const Vec2 r = ball.sunk ? resting_place(state.table, ball.r) : ball.r;
        const Orientation& lie =
            spin.follow(ball.id, r, state.ball_radius, kJump * state.table.length);
        const float radius = ball.sunk ? kSunkSize * layout.ball : layout.ball;
        ball_art.draw(canvas, i, layout.to_pixels(r),
                      {look_of(ball.id), lie, radius, {0, 0}, ball.sunk});
    }
}

void TableView::Parts::reset() {
    canvas.reset();
    text.reset();
    table_art.reset();
    ball_art.reset();
}

TableView::TableView(SDL_Renderer* renderer) : parts_(std::make_unique<Parts>(renderer)) {}

TableView::~TableView() = default;

void TableView::draw(const ViewState& state, double now_s) {
    Parts& parts = *parts_;
    parts.canvas.begin(to_colour(kRoom));
    if (parts.canvas.width() <= 0 || parts.canvas.height() <= 0) return;
    parts.layout =
        layout_of(state.table, state.ball_radius, parts.canvas.width(), parts.canvas.height());
    parts.table_art.draw(parts.canvas, state.table, parts.layout, now_s);
    parts.draw_cloth_shapes(state);
    parts.draw_balls(state);
    add_solver_ghosts(parts.canvas.shapes(), parts.layout, state.solvers);
    add_collision_marks(parts.canvas.shapes(), parts.layout, state.marks);
    add_mode_icons(parts.canvas.shapes(), parts.layout, state);
    draw_top_bar(parts.canvas, parts.text, parts.layout, state.match);
    draw_bottom_lines(parts.canvas, parts.text, parts.layout, state);
    draw_solver_legend(parts.canvas, parts.text, parts.layout, state.solvers);
    if (state.help) {
        draw_help(parts.canvas, parts.text, parts.layout);
    } else if (state.banner) {
        draw_banner(parts.canvas, parts.text, parts.layout, *state.banner);
    }
    parts.canvas.finish();
}

void TableView::handle_event(const SDL_Event& event) {
    if (event.type == SDL_RENDER_TARGETS_RESET || event.type == SDL_RENDER_DEVICE_RESET)
        parts_->reset();
}

Vec2 TableView::to_table(SDL_FPoint pixel) const {
    return parts_->layout.to_table(pixel);
}

SDL_FPoint TableView::to_pixels(Vec2 table) const {
    return parts_->layout.to_pixels(table);
}

}  // namespace poolhall::client
