#include "client/desktop/view/hud.hpp"

#include "client/desktop/render/colour.hpp"
#include "client/play/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace poolhall::client {
namespace {

constexpr SDL_Color kPanel{38, 42, 50, 255};
constexpr SDL_Color kPanelEdge{62, 68, 80, 255};
constexpr SDL_Color kGold{246, 200, 95, 255};
constexpr SDL_Color kBright{240, 242, 245, 255};
constexpr SDL_Color kDim{160, 168, 180, 255};
constexpr SDL_Color kGood{92, 208, 140, 255};
constexpr SDL_Color kWarn{255, 168, 76, 255};
constexpr std::string_view kBetween = "  \xC2\xB7  ";

constexpr std::uint32_t kHurry = 10;  ///< s of the shot clock

// A seat's panel, in pixels.
struct SeatPanel {
    SDL_FRect box;
    const SeatView& seat;
    bool turn;
    std::optional<std::uint32_t> seconds_left;  ///< of its turn, where a clock runs
};

void add_turn_marker(Mesh& mesh, SDL_FPoint left_middle, float size) {
    const std::array<SDL_FPoint, 3> arrow{{{left_middle.x, left_middle.y - size / 2},
                                           {left_middle.x + 0.85F * size, left_middle.y},
                                           {left_middle.x, left_middle.y + size / 2}}};
    add_convex(mesh, arrow, kGold);
}

// Told apart by shape as well as colour: full when all is well, a ring while it is not.
void add_connection_dot(Mesh& mesh, SDL_FPoint at, float radius, Link link) {
    if (link == Link::kOnline) {
        add_disc(mesh, at, radius, kGood);
    } else {
        const SDL_Color colour = link == Link::kOffline ? kDim : kWarn;
        add_ring(mesh, at, 0.8F * radius, {std::max(1.2F, 0.45F * radius), colour});
    }
}

std::string second_line(const SeatPanel& panel, bool online) {
    const SeatView& seat = panel.seat;
    if (seat.name.empty()) return "waiting for a player";
    std::string line = online ? (seat.connected ? "connected" : "away") : "";
    const auto add = [&line](std::string_view part) {
        if (!line.empty()) line += ", ";
        line += part;
    };
    if (seat.wants_rematch) add("wants a rematch");
    if (panel.turn) add("to shoot");
    if (panel.seconds_left) add(clock_text(*panel.seconds_left) + " left");
    return line;
}

float draw_wins(Text& text, const Layout& layout, const SeatPanel& panel) {
    const SDL_FRect& box = panel.box;
    const float x = box.x + box.w - 30 * layout.ui;
    const float big = text_size(layout, 24);
    text.draw(std::to_string(panel.seat.wins), {big, kBright, true},
              {x, box.y + 0.38F * box.h, Align::kCentre});
    text.draw(panel.seat.wins == 1 ? "win" : "wins", {text_size(layout, 12), kDim},
              {x, box.y + 0.76F * box.h, Align::kCentre});
    return 60 * layout.ui;
}

void draw_name(Text& text, const Layout& layout, const SeatView& seat, const TextPlace& place) {
    const bool open = seat.name.empty();
    const TextStyle small{text_size(layout, 14), kGold};
    const float mark = seat.mine ? text.width("you", small) + 10 * layout.ui : 0;
    const TextStyle style{text_size(layout, 19), open ? kDim : kBright, !open};
    const float width = text.draw(open ? "Open seat" : seat.name, style,
                                  {place.x, place.y, place.align, place.max_width - mark});
    if (seat.mine) text.draw("you", small, {place.x + width + 10 * layout.ui, place.y + 1});
}

void draw_seat(Canvas& canvas, Text& text, const Layout& layout, const SeatPanel& panel,
               bool online) {
    const SDL_FRect& box = panel.box;
    const float ui = layout.ui;
    Mesh& shapes = canvas.shapes();
    const bool open = panel.seat.name.empty();
    add_rounded_rect(shapes, box, 9 * ui, open ? faded(kPanel, 0.55F) : kPanel);
    add_rounded_frame(shapes, box, 9 * ui,
                      {panel.turn ? 2.2F * ui : 1, panel.turn ? kGold : kPanelEdge});
    if (panel.turn) add_turn_marker(shapes, {box.x + 13 * ui, box.y + box.h / 2}, 18 * ui);
    const float left = box.x + 38 * ui;
    const float wins = open ? 0 : draw_wins(text, layout, panel);
    const float room = box.x + box.w - wins - left - 6 * ui;
    const std::string below = second_line(panel, online);
    const float first_row = box.y + (below.empty() ? 0.5F : 0.33F) * box.h;
    const float second_row = box.y + 0.72F * box.h;
    draw_name(text, layout, panel.seat, {left, first_row, Align::kLeft, room});
    float x = left;
    if (online && !open) {
        add_connection_dot(shapes, {x + 5 * ui, second_row}, 5 * ui,
                           panel.seat.connected ? Link::kOnline : Link::kLost);
        x += 16 * ui;
    }
    const bool hurry = panel.seconds_left && *panel.seconds_left <= kHurry;
    text.draw(below, {text_size(layout, 13), hurry ? kWarn : kDim, hurry},
              {x, second_row, Align::kLeft, left + room - x});
}

void draw_code(Text& text, const Layout& layout, const MatchView& match, float room) {
    const float x = layout.top.x + layout.top.w / 2;
    if (match.code.empty()) {
        const char* title = match.link == Link::kOffline ? "Practice" : "Poolhall";
        text.draw(title, {text_size(layout, 26), kBright, true},
                  {x, layout.top.h / 2, Align::kCentre, room});
        return;
    }
    text.draw("JOIN CODE", {text_size(layout, 12), kDim},
              {x, 0.22F * layout.top.h, Align::kCentre, room});
    text.draw(match.code, {text_size(layout, 36), kGold, true},
              {x, 0.60F * layout.top.h, Align::kCentre, room});
}

std::string_view words(Link link) {
    switch (link) {
        case Link::kOffline:
            return "Offline";
        case Link::kConnecting:
            return "Connecting";
        case Link::kOnline:
            return "Online";
        case Link::kLost:
            return "Connection lost";
    }
    return "";
}

// A loudspeaker, crossed out.
void add_mute_mark(Mesh& mesh, SDL_FPoint middle, float size) {
    const auto at = [&](float x, float y) {
        return SDL_FPoint{middle.x + x * size, middle.y + y * size};
    };
    const std::array<SDL_FPoint, 4> box{at(-0.5F, -0.17F), at(-0.25F, -0.17F), at(-0.25F, 0.17F),
                                        at(-0.5F, 0.17F)};
    const std::array<SDL_FPoint, 4> cone{at(-0.25F, -0.17F), at(0.08F, -0.45F), at(0.08F, 0.45F),
                                         at(-0.25F, 0.17F)};
    add_convex(mesh, box, kDim);
    add_convex(mesh, cone, kDim);
    const Stroke cross{std::max(1.5F, 0.12F * size), kWarn};
    add_line(mesh, at(0.20F, -0.2F), at(0.60F, 0.2F), cross);
    add_line(mesh, at(0.60F, -0.2F), at(0.20F, 0.2F), cross);
}

}  // namespace

float text_size(const Layout& layout, float size) {
    return std::max(size * layout.ui, 10.0F);
}

std::string connection_line(const ViewState& state) {
    const MatchView& match = state.match;
    std::string line(words(match.link));
    std::array<char, 32> number{};
    if (match.link == Link::kOnline && match.round_trip_ms) {
        std::snprintf(number.data(), number.size(), ", %.0f ms", *match.round_trip_ms);
        line += number.data();
    }
    if (match.spectators > 0)
        line += std::string(kBetween) + std::to_string(match.spectators) + " watching";
    if (!state.physics.empty()) line += std::string(kBetween) + state.physics;
    if (state.frames_per_second) {
        std::snprintf(number.data(), number.size(), "%.0f fps", *state.frames_per_second);
        line += kBetween;
        line += *state.frames_per_second > 0 ? number.data() : "at rest";
    }
    return line;
}

void draw_top_bar(Canvas& canvas, Text& text, const Layout& layout, const MatchView& match) {
    const float ui = layout.ui;
    const float margin = 14 * ui;
    const float panel = std::min(0.345F * layout.top.w, 430 * ui);
    const float height = layout.top.h - 18 * ui;
    const std::array<float, kSeatCount> lefts{margin, layout.top.w - margin - panel};
    for (std::size_t i = 0; i < lefts.size(); ++i) {
        const bool turn = match.turn && match.turn->value == i;
        const bool online = match.link != Link::kOffline;
        const auto seconds_left = turn ? match.seconds_left : std::nullopt;
        draw_seat(canvas, text, layout,
                  {{lefts[i], 10 * ui, panel, height}, match.seats[i], turn, seconds_left}, online);
    }
    draw_code(text, layout, match, layout.top.w - 2 * (panel + margin) - 12 * ui);
}

void draw_bottom_lines(Canvas& canvas, Text& text, const Layout& layout, const ViewState& state) {
    const float ui = layout.ui;
    const SDL_FRect& area = layout.bottom;
    const float margin = 18 * ui;
    const float first_row = area.y + 0.30F * area.h;
    const float second_row = area.y + 0.74F * area.h;
    text.draw(state.hint, {text_size(layout, 18), kBright},
              {area.w / 2, first_row, Align::kCentre, area.w - 2 * margin});

    float right = area.w - margin;
    if (state.muted) {
        const float size = std::max(20 * ui, 12.0F);
        add_mute_mark(canvas.shapes(), {right - 0.6F * size, second_row}, size);
        right -= 1.2F * size + 4 * ui;
        right -=
            text.draw("muted", {text_size(layout, 13), kDim}, {right, second_row, Align::kRight}) +
            16 * ui;
    }
    const bool lost = state.match.link == Link::kLost;
    const TextStyle style{text_size(layout, 13), lost ? kWarn : kDim, lost};
    const float width =
        text.draw(connection_line(state), style, {right, second_row, Align::kRight, 0.6F * area.w});
    add_connection_dot(canvas.shapes(), {right - width - 11 * ui, second_row}, 5 * ui,
                       state.match.link);
    text.draw(state.status, {text_size(layout, 14), kGold},
              {margin, second_row, Align::kLeft, right - width - 22 * ui - 2 * margin});
}

}  // namespace poolhall::client
