#pragma once

#include "shared/physics/search/box.hpp"
#include "shared/table/pool_table.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace poolhall {

/// A pool table and where each piece of it is: a ball touches a piece only where the box of its
/// surface meets the piece's, and drops only where that of its centre meets the hole's. Boxes of
/// balls are wider than any rounding, so no piece that is met is left out.
class CushionMap {
  public:
    /// As PoolTable.
    explicit CushionMap(const Table& table);

    [[nodiscard]] const PoolTable& table() const { return table_; }

    /// Calls visit(line) for those that may be touched within the surface's box, in their order.
    template <class Visit>
    void for_each_line_near(const Box& surface, Visit visit) const {
        const auto lines = table_.lines();
        for (std::size_t i = 0; i < kNoseCount; ++i) {
            if (!are_apart(surface, noses_[i])) visit(lines[i]);
        }
        for_each_mouth_near(surface, [&](const Mouth& mouth, std::size_t place) {
            for (std::size_t i = 0; i < 2; ++i) {
                if (!are_apart(surface, mouth.facings[i])) visit(lines[kNoseCount + 2 * place + i]);
            }
        });
    }

    /// The same with arcs.
    template <class Visit>
    void for_each_arc_near(const Box& surface, Visit visit) const {
        for_each_mouth_near(surface, [&](const Mouth& mouth, std::size_t place) {
            for (std::size_t i = 0; i < 2; ++i) {
                if (!are_apart(surface, mouth.arcs[i])) visit(table_.arcs()[2 * place + i]);
            }
        });
    }

    /// Calls visit(place) for the holes that a centre in the box may drop into, in their order.
    template <class Visit>
    void for_each_hole_near(const Box& centres, Visit visit) const {
        for_each_mouth_near(centres, [&](const Mouth& mouth, std::size_t place) {
            if (!are_apart(centres, mouth.hole)) visit(place);
        });
    }

  private:
    static constexpr std::size_t kNoseCount = 6;

    /// The pieces around one pocket.
    struct Mouth {
        Box all;
        std::array<Box, 2> facings;
        std::array<Box, 2> arcs;
        Box hole;
    };

    template <class Visit>
    void for_each_mouth_near(const Box& box, Visit visit) const {
        for (std::size_t place = 0; place < mouths_.size(); ++place) {
            if (!are_apart(box, mouths_[place].all)) visit(mouths_[place], place);
        }
    }

    PoolTable table_;
    std::array<Box, kNoseCount> noses_;
    std::array<Mouth, kPocketCount> mouths_;  ///< in the order of Pocket, as jaws and facings are
};

/// The map of the last table that was asked for: making one takes as long as three events.
class KeptCushionMap {
  public:
    [[nodiscard]] const CushionMap& of(const Table& table) {
        if (!map_ || !(key_ == table)) {
            key_ = table;
            map_.emplace(table);
        }
        return *map_;
    }

  private:
    Table key_;
    std::optional<CushionMap> map_;
};

}  // namespace poolhall
