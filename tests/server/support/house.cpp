#include "tests/server/support/house.hpp"

#include <stdexcept>
#include <thread>
#include <utility>

namespace poolhall::server::test {

namespace {

std::unique_ptr<ReplayStore> open_store(const std::filesystem::path& folder) {
    auto store = ReplayStore::open({folder});
    if (!store) throw std::runtime_error(store.error().reason);
    return std::move(*store);
}

}  // namespace

House::House(RoomLimits limits, std::size_t max_matches, std::size_t loops)
    : shards_(loops),
      store_(open_store(folder_.path())),
      lobby_(std::make_unique<Lobby>(
          LobbyServices{*store_, shards_, counters_, limits, max_matches})) {}

House::~House() {
    settle();
}

void House::settle() {
    for (bool ran = true; ran;) {
        store_->flush();
        ran = shards_.run_ready();
    }
}

void House::wait_and_settle() {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    settle();
}

void House::run_for(std::chrono::milliseconds time) {
    const auto end = LoopTimer::Clock::now() + time;
    while (LoopTimer::Clock::now() < end)
        wait_and_settle();
}

void House::run_to_the_store() {
    shards_.run_ready();
    store_->flush();
}

StoredMatch House::stored() {
    auto open = store_->load_open_matches();
    if (!open) throw std::runtime_error(open.error().reason);
    return open->matches.at(0);
}

Guest::Guest(House& house) : house_(house), member_{house.next_member(), {}, {}} {
    house_.shards().at({}).add(member_.id, outlet_);
}

Guest::~Guest() {
    disconnect();
}

Request Guest::next_request() {
    return Request({house_.shards(), house_.counters(), member_, ++seq_, standing_,
                    [this](Standing now) { standing_ = std::move(now); }});
}

void Guest::send(const protocol::ClientBody& body) {
    std::visit(
        [&]<class T>(const T& command) {
            if constexpr (std::is_same_v<T, protocol::EntryCommand>)
                house_.lobby().enter(next_request(), command);
            else if constexpr (!std::is_same_v<T, protocol::Ping>)
                standing_.room->submit(next_request(), command);
        },
        body);
}

std::optional<protocol::Reject> Guest::ask(const protocol::ClientBody& command) {
    send(command);
    house_.settle();
    const auto* reject = newest<protocol::Reject>();
    return reject && reject->seq == seq_ ? std::optional(*reject) : std::nullopt;
}

std::string Guest::code_of(const protocol::ClientBody& command) {
    const auto reject = ask(command);
    return reject ? std::string(name(reject->code)) : std::string();
}

protocol::Joined Guest::enter(const protocol::EntryCommand& command) {
    if (const auto reject = ask(command)) throw std::runtime_error(reject->reason);
    return *newest<protocol::Joined>();
}

void Guest::disconnect() {
    if (const auto room = std::exchange(standing_, {}).room) room->disconnect(member_.id);
    house_.shards().at({}).remove(member_.id);
    house_.settle();
}

const protocol::TableState& Guest::table() const {
    using namespace protocol;
    for (auto message = outlet_->got.rbegin(); message != outlet_->got.rend(); ++message) {
        if (const auto* changed = std::get_if<TableChanged>(&*message)) return changed->table;
        if (const auto* ended = std::get_if<ShotEnded>(&*message)) return ended->table;
        if (const auto* joined = std::get_if<Joined>(&*message)) return joined->table;
    }
    throw std::runtime_error("no table was told");
}

Duel::Duel(House& house, std::optional<MatchSettings> settings) : ada(house), ben(house) {
    adas = ada.enter(protocol::CreateMatch{"Ada", "end_game", {}, std::move(settings)});
    bens = ben.enter(protocol::JoinMatch{adas.table.code, "Ben"});
}

}  // namespace poolhall::server::test
