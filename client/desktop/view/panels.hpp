#pragma once

#include "client/desktop/render/text.hpp"
#include "client/desktop/view/layout.hpp"
#include "client/play/view_state.hpp"

// What is laid over the table.
namespace poolhall::client {

/// The large message; won, lost and the rest differ in symbol as well as in colour.
void draw_banner(Canvas& canvas, Text& text, const Layout& layout, const Banner& banner);
/// kKeyTable.
void draw_help(Canvas& canvas, Text& text);

}  // namespace poolhall::client
