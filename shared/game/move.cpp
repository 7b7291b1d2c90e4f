#include "shared/game/move.hpp"

namespace poolhall {

std::string_view name(Accord accord) {
    switch (accord) {
        case Accord::kRematch:
            return "rematch";
    }
    return {};
}

}  // namespace poolhall
