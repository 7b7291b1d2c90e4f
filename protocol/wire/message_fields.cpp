#include "protocol/wire/message_fields.hpp"

namespace poolhall::protocol::wire {

bool TableCodec::read(const Cursor& cursor, TableState& table) const {
    if (!read_fields(cursor, table)) return false;
    const std::size_t balls = table.state.scene.balls.size();
    if (table.live && table.live->balls.size() != balls) {
        return cursor.refuse_at("/live/balls", "must have one position for each ball of the scene");
    }
    return true;
}

}  // namespace poolhall::protocol::wire
