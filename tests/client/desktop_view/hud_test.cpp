#include "client/desktop/view/hud.hpp"

#include "client/desktop/view/help_text.hpp"

#include <gtest/gtest.h>
#include <set>

namespace poolhall::client {
namespace {

TEST(ConnectionLineTest, SaysHowTheConnectionIs) {
    ViewState state;
    EXPECT_EQ(connection_line(state), "Offline");
    state.match.link = Link::kOnline;
    state.match.round_trip_ms = 22.6;
    EXPECT_EQ(connection_line(state), "Online, 23 ms");
    state.match.link = Link::kLost;
    EXPECT_EQ(connection_line(state), "Connection lost");
}

TEST(ConnectionLineTest, CountsSpectatorsAndFrames) {
    ViewState state;
    state.match.spectators = 3;
    state.frames_per_second = 59.94;
    EXPECT_EQ(connection_line(state), "Offline  \xC2\xB7  3 watching  \xC2\xB7  60 fps");
    state.frames_per_second = 0;
    EXPECT_EQ(connection_line(state), "Offline  \xC2\xB7  3 watching  \xC2\xB7  at rest");
}

TEST(ConnectionLineTest, NamesThePhysics) {
    ViewState state;
    state.physics = "event, everything";
    EXPECT_EQ(connection_line(state), "Offline  \xC2\xB7  event, everything");
}

TEST(HelpTextTest, EachKeyIsThereOnceAndHasAnAction) {
    std::set<std::string_view> keys;
    for (const KeyRow& row : kKeyTable) {
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_FALSE(row.action.empty()) << row.key;
        EXPECT_EQ(row.action.find('|'), std::string_view::npos) << "README shows it in a table";
    }
    for (const char* key : {"Esc", "F1", "F2", "F3", "F4", "Space", "P", "M", "H", "C", "Mouse"})
        EXPECT_EQ(keys.count(key), 1U) << key;
}

}  // namespace
}  // namespace poolhall::client
