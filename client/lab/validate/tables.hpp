#pragma once

#include "client/lab/validate/curves.hpp"
#include "client/lab/validate/measured_table.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

// Every published measurement that we are held against, a file a subject. Each file has its
// published numbers at its top, with their sources, and what is simulated for them below.
//
// Sources, by the names that the tables use:
// M09  S. Mathavan, M. R. Jackson, R. M. Parkin, "Application of high-speed imaging to determine
// the
//      dynamics of billiards", American Journal of Physics 77(9), 788, 2009.
// M10  The same, "A theoretical analysis of billiard ball dynamics under cushion impacts", Proc.
//      IMechE C 224(9), 1863, 2010.
// M14  The same, "Numerical simulations of the frictional collisions of solid balls on a rough
//      surface", Sports Engineering 17, 227, 2014.
// TP, BD  D. Alciatore, technical proofs, and columns in Billiards Digest: drdavepoolinfo.com.
namespace poolhall::lab {

/// Formulas with worked values: a test of the code, not of the model.
[[nodiscard]] std::vector<MeasuredTable> worked_value_tables();
/// Five shots filmed at high speed, M09.
[[nodiscard]] std::vector<MeasuredTable> two_ball_tables();
/// A ball into a rail: M09, M10, and the recorded three-cushion shots.
[[nodiscard]] std::vector<MeasuredTable> cushion_tables();
/// Rolling, sliding, spinning on the cloth.
[[nodiscard]] std::vector<MeasuredTable> cloth_tables();
/// Throw, squirt, friction of balls.
[[nodiscard]] std::vector<MeasuredTable> cloth_and_cue_tables();
/// Corner pockets, what they take of a ball's offset.
[[nodiscard]] std::vector<MeasuredTable> pocket_tables();
/// Diamond systems, rail speed, 30-degree rule.
[[nodiscard]] std::vector<MeasuredTable> practice_tables();
/// What breaks bring, over so many of them.
[[nodiscard]] std::vector<MeasuredTable> break_tables(std::uint64_t seed, std::size_t breaks);

[[nodiscard]] std::vector<Figure> two_ball_figures();
[[nodiscard]] std::vector<Figure> cushion_figures();
[[nodiscard]] std::vector<Figure> cloth_and_cue_figures();

}  // namespace poolhall::lab
