#include "server/room/request.hpp"

#include "tests/server/support/house.hpp"

#include <gtest/gtest.h>

namespace poolhall::server::test {
namespace {

using namespace protocol;

class RequestTest : public testing::Test {
  protected:
    RequestTest() { shards.at({}).add(member.id, outlet); }

    Request request() {
        return Request({shards, counters, member, 7, {nullptr, true}, [this](Standing now) {
                            answered = std::move(now);
                        }});
    }

    const ServerMessage& answer() {
        shards.run_ready();
        return outlet->got.at(0);
    }

    Shards shards{1};
    Counters counters;
    Member member{MemberId{1}, {}, {}};
    std::shared_ptr<FakeOutlet> outlet = std::make_shared<FakeOutlet>();
    std::optional<Standing> answered;
};

TEST_F(RequestTest, AcceptanceNamesTheCommandAndWhereTheMemberStands) {
    request().accept({nullptr, false});
    EXPECT_EQ(answer(), ServerMessage(Accepted{7}));
    EXPECT_FALSE(answered->seated);
}

TEST_F(RequestTest, RejectionLeavesTheMemberWhereItStood) {
    request().reject({RejectCode::kIllegal, "No."});
    EXPECT_EQ(answer(), ServerMessage(Reject{7, RejectCode::kIllegal, "No."}));
    EXPECT_TRUE(answered->seated);
    EXPECT_EQ(counters.rejects.load(), 1U);
}

TEST_F(RequestTest, JoinedNamesTheCommand) {
    request().join({}, {nullptr, true});
    EXPECT_EQ(std::get<Joined>(answer()).seq, 7U);
}

TEST_F(RequestTest, MovedRequestIsAnsweredOnce) {
    Request first = request();
    Request second = std::move(first);
    std::move(second).accept({});
    EXPECT_EQ(answer(), ServerMessage(Accepted{7}));
    EXPECT_EQ(outlet->got.size(), 1U);
}

TEST_F(RequestTest, RequestThatIsDroppedStopsADebugBuildAndIsElseRejected) {
#ifdef NDEBUG
    { const Request dropped = request(); }
    EXPECT_EQ(std::get<Reject>(answer()).seq, 7U);
    EXPECT_TRUE(answered.has_value());
#else
    EXPECT_DEATH({ const Request dropped = request(); }, "without an answer");
#endif
}

}  // namespace
}  // namespace poolhall::server::test
