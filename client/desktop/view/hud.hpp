#pragma once

#include "client/desktop/render/text.hpp"
#include "client/desktop/view/layout.hpp"
#include "client/play/view_state.hpp"

#include <string>

// Everything written around the table.
namespace poolhall::client {

/// Seats and join code over the table.
void draw_top_bar(Canvas& canvas, Text& text, const Layout& layout, const MatchView& match);
/// Hint, status and connection below the table.
void draw_bottom_lines(Canvas& canvas, Text& text, const Layout& layout, const ViewState& state);

/// "Online, 23 ms - 3 watching - 60 fps" with dots between.
[[nodiscard]] std::string connection_line(const ViewState& state);

/// Size of text that is `size` px high at 1280 x 720; never too small to read.
[[nodiscard]] float text_size(const Layout& layout, float size);

}  // namespace poolhall::client
