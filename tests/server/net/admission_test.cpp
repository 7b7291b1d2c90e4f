#include "server/net/admission.hpp"

#include <boost/asio/ip/address.hpp>

#include <gtest/gtest.h>
#include <string>
#include <thread>
#include <vector>

namespace poolhall::server {
namespace {

boost::asio::ip::address ip(const std::string& text) {
    return boost::asio::ip::make_address(text);
}

/// A connection; `closed` once it has had to go.
struct Connection {
    std::shared_ptr<Admission::Place> place;
    bool closed = false;

    explicit operator bool() const { return place != nullptr; }
};

class AdmissionTest : public testing::Test {
  protected:
    std::unique_ptr<Connection> connect(const std::string& from) {
        auto connection = std::make_unique<Connection>();
        connection->place = admission.admit(ip(from));
        const bool waits =
            !connection->place || connection->place->wait([&c = *connection] { c.closed = true; });
        EXPECT_TRUE(waits);
        return connection;
    }

    std::vector<std::unique_ptr<Connection>> connect(int count, const std::string& from) {
        std::vector<std::unique_ptr<Connection>> all;
        for (int i = 0; i < count; ++i)
            all.push_back(connect(from));
        return all;
    }

    static int closed(const std::vector<std::unique_ptr<Connection>>& all) {
        int count = 0;
        for (const auto& one : all)
            count += one->closed ? 1 : 0;
        return count;
    }

    Counters counters;
    Admission admission{{10, 4}, counters};
};

TEST_F(AdmissionTest, TheOldestSilentConnectionOfAFullAddressMakesRoomForItsNext) {
    const auto first = connect(4, "192.0.2.1");
    EXPECT_EQ(closed(first), 0);
    EXPECT_TRUE(*connect("192.0.2.1"));
    EXPECT_TRUE(first[0]->closed);
    EXPECT_EQ(closed(first), 1);
    EXPECT_EQ(counters.connections_evicted.load(), 1U);
    EXPECT_EQ(counters.connections_refused.load(), 0U);
}

TEST_F(AdmissionTest, ConnectionsAtWorkStay) {
    const auto first = connect(4, "192.0.2.1");
    for (const auto& one : first)
        EXPECT_TRUE(one->place->work());
    EXPECT_FALSE(*connect("192.0.2.1"));
    EXPECT_EQ(counters.connections_refused.load(), 1U);
    EXPECT_TRUE(*connect("192.0.2.2"));
    EXPECT_TRUE(first[2]->place->wait([&] { first[2]->closed = true; }));
    EXPECT_TRUE(*connect("192.0.2.1"));
    EXPECT_TRUE(first[2]->closed);
}

TEST_F(AdmissionTest, AFullServerClosesTheOldestOfTheAddressWithMostSilentOnes) {
    const auto few = connect(2, "192.0.2.1");
    const auto most = connect(4, "192.0.2.2");
    const auto busy = connect(4, "192.0.2.3");
    for (const auto& one : busy)
        EXPECT_TRUE(one->place->work());
    EXPECT_TRUE(*connect("198.51.100.1"));
    EXPECT_TRUE(most[0]->closed);
    EXPECT_EQ(closed(few) + closed(most) + closed(busy), 1);
}

TEST_F(AdmissionTest, ManySilentConnectionsOfOneAddressKeepNobodyOut) {
    Admission unbounded({10, 0}, counters);
    std::vector<std::shared_ptr<Admission::Place>> silent;
    for (int i = 0; i < 1000; ++i) {
        silent.push_back(unbounded.admit(ip("192.0.2.1")));
        ASSERT_TRUE(silent.back());
    }
    const auto other = unbounded.admit(ip("192.0.2.2"));
    ASSERT_TRUE(other);
    EXPECT_TRUE(other->work());
    for (int i = 0; i < 100; ++i)
        silent.push_back(unbounded.admit(ip("192.0.2.1")));
    EXPECT_TRUE(other->work()) << "the attack took the place of a connection at work";
}

TEST_F(AdmissionTest, APlaceThatIsGivenAwayIsNoPlaceForWork) {
    const auto first = connect(4, "192.0.2.1");
    const auto next = connect("192.0.2.1");
    EXPECT_FALSE(first[0]->place->work());
    EXPECT_FALSE(first[0]->place->wait([] {}));
    first[0]->place.reset();
    const auto third = connect("192.0.2.1");
    EXPECT_EQ(closed(first), 2);
}

TEST_F(AdmissionTest, PlacesComeBackWhenConnectionsEnd) {
    for (int i = 0; i < 100; ++i) {
        const auto all = connect(4, "192.0.2.1");
        for (const auto& one : all)
            EXPECT_TRUE(one->place->work());
    }
    EXPECT_EQ(counters.connections_refused.load(), 0U);
    EXPECT_EQ(counters.connections_evicted.load(), 0U);
}

TEST_F(AdmissionTest, ThisMachineHasAReserveForHealthChecks) {
    std::vector<std::unique_ptr<Connection>> busy;
    for (const char* from : {"192.0.2.1", "192.0.2.2", "127.0.0.1"})
        for (auto& one : connect(from == std::string("127.0.0.1") ? 4 : 3, from)) {
            EXPECT_TRUE(one->place->work());
            EXPECT_FALSE(one->place->is_reserved());
            busy.push_back(std::move(one));
        }
    EXPECT_FALSE(*connect("192.0.2.3"));
    for (const char* local : {"127.0.0.1", "::1", "::ffff:127.0.0.1"}) {
        const auto check = connect(local);
        ASSERT_TRUE(*check) << local;
        EXPECT_TRUE(check->place->is_reserved());
    }
    const auto many = connect(100, "127.0.0.1");
    for (const auto& one : many)
        EXPECT_TRUE(*one);
    EXPECT_EQ(closed(many), 92) << "the reserve has 8 places";
}

TEST_F(AdmissionTest, ANetworkOfIpv6IsOneAddress) {
    EXPECT_EQ(admission_group(ip("2001:db8:1:2:3:4:5:6")), "2001:db8:1:2::/64");
    EXPECT_EQ(admission_group(ip("2001:db8:1:2::1")), "2001:db8:1:2::/64");
    EXPECT_NE(admission_group(ip("2001:db8:1:3::1")), "2001:db8:1:2::/64");
    EXPECT_EQ(admission_group(ip("::ffff:192.0.2.1")), admission_group(ip("192.0.2.1")));
}

TEST_F(AdmissionTest, ThreadsMayComeAndGoAtOnce) {
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread) {
        threads.emplace_back([this, thread] {
            for (int i = 0; i < 5000; ++i) {
                const auto place =
                    admission.admit(ip("192.0.2." + std::to_string(i % 3 + thread % 2)));
                if (place && place->wait([] {}) && i % 2 == 0) static_cast<void>(place->work());
            }
        });
    }
    for (auto& thread : threads)
        thread.join();
    EXPECT_EQ(connect(4, "192.0.2.1").size(), 4U);
}

}  // namespace
}  // namespace poolhall::server
