#include "shared/enum_names.hpp"

#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <gtest/gtest.h>

namespace poolhall {
namespace {

template <class E>
class EnumNames : public ::testing::Test {};

using Enums = ::testing::Types<Rail, Pocket, PocketModel, Motion, EventKind, Outcome, SolverKind,
                               BallBallModel, RailModel>;
TYPED_TEST_SUITE(EnumNames, Enums);

TYPED_TEST(EnumNames, LeadBackToTheirEnumerators) {
    EXPECT_EQ(kCount<TypeParam>, kValues<TypeParam>.size());
    for (const TypeParam value : kValues<TypeParam>) {
        if (name(value).empty()) continue;
        EXPECT_EQ(value, find<TypeParam>(name(value)));
    }
}

TYPED_TEST(EnumNames, AreFoundByNoOtherText) {
    EXPECT_FALSE(find<TypeParam>(""));
    EXPECT_FALSE(find<TypeParam>("kNone"));
    EXPECT_FALSE(find<TypeParam>("of no enumerator"));
}

TEST(EnumNamesInFiles, AreThoseThatFilesHave) {
    EXPECT_EQ("NE.E", name(Rail::kNorthEastJawE));
    EXPECT_EQ("SW", name(Pocket::kSouthWest));
    EXPECT_EQ("", name(PocketModel::kCircles));
    EXPECT_EQ("slide_to_roll", name(EventKind::kSlideToRoll));
    EXPECT_EQ("mathavan2010_fast", name(RailModel::kMathavan2010Fast));
    EXPECT_EQ(SolverKind::kSemiImplicit, find<SolverKind>("semi_implicit"));
}

}  // namespace
}  // namespace poolhall
