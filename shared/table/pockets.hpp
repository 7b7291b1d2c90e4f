#pragma once

#include "shared/table/table.hpp"

#include <optional>

namespace poolhall {

/// A ball's capture by a pocket.
struct Capture {
    Real t = 0;  ///< s from now
    Pocket pocket = Pocket::kNorthWest;
};

/// The original game's pockets: no holes in the rails, but places near them. A ball is captured as
/// soon as its centre is within 1.5 radii of a long rail and also within 1.5 radii of a short rail
/// (corner) or within 0.75 radii of the middle of the table (centre pocket). Source: the game's
/// text, 5.2.3, with the numbers of its derivatives.
class EndGamePocketMap {
  public:
    EndGamePocketMap(const Table& table, Real radius);

    /// The pocket that holds a ball centred at r.
    [[nodiscard]] std::optional<Pocket> at(Vec2 r) const;
    /// The first capture of a ball that moves from r with velocity v, within `time` s.
    [[nodiscard]] std::optional<Capture> first_capture(Vec2 r, Vec2 v, Real time) const;
    /// Where the pocket is drawn and where its ball is shown: a point on the rails, m.
    [[nodiscard]] static Vec2 mouth(const Table& table, Pocket pocket);

    // The lines that bound the captures, m.
    [[nodiscard]] Real corner_x() const { return corner_x_; }

    [[nodiscard]] Real near_rail_y() const { return near_rail_y_; }

    [[nodiscard]] Real centre_x() const { return centre_x_; }

  private:
    Real corner_x_;     ///< corner capture from |x| >= this, m
    Real near_rail_y_;  ///< any capture from |y| >= this, m
    Real centre_x_;     ///< centre capture up to |x| <= this, m
};

}  // namespace poolhall
