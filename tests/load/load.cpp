#include "client/lab/output/build_info.hpp"
#include "tests/e2e/server_process.hpp"
#include "tests/load/player.hpp"
#include "tests/load/process_cost.hpp"

#include <boost/asio/io_context.hpp>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

// What the server costs, measured on the real program from outside. Prints CSV.
namespace poolhall::load {
namespace {

using protocol::Encoding;
using protocol::Stream;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kIdleMatches = 500;
constexpr std::size_t kIdleSessions = 1000;
constexpr std::size_t kSpectators = 500;

struct LoadSpec {
    std::size_t matches = 100;
    double seconds = 10;  ///< of each measurement
};

void print(const std::string& figure, double value, const char* unit) {
    std::printf("%s,%.6g,%s\n", figure.c_str(), value, unit);
    std::fflush(stdout);
}

/// The lines above the table; the server is built by the same compiler with the same flags.
void print_build() {
    const lab::BuildInfo info = lab::build_info();
    std::printf("# compiler: %s\n# flags: %s\n# processor: %s\n", info.compiler.c_str(),
                info.flags.c_str(), info.processor.c_str());
}

/// A server of its own, and the clients.
class Scene {
  public:
    Scene() : server_(folder_.path(), {"--log-level", "warn", "--max-per-address", "0"}) {}

    Player& add(Encoding encoding) {
        return players_.emplace_back(context_, server_.port(), encoding);
    }

    void open_match(Encoding encoding) {
        Player& creator = add(encoding);
        creator.send(protocol::CreateMatch{"Ada"});
        run_until([&] { return !creator.code().empty(); });
    }

    /// A match with two players, one in each encoding.
    void open_table() {
        open_match(Encoding::kJson);
        const std::string code = players_.back().code();
        Player& other = add(Encoding::kCbor);
        other.send(protocol::JoinMatch{code, "Ben"});
        run_until([&] { return !other.code().empty(); });
    }

    void play() {
        for (Player& player : players_)
            player.set_playing(true);
    }

    template <class Done>
    void run_until(Done done) {
        while (!done()) {
            context_.restart();
            context_.run_one_for(std::chrono::milliseconds(10));
        }
    }

    void run_for(double seconds) {
        const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                            std::chrono::duration<double>(seconds));
        run_until([end] { return Clock::now() >= end; });
    }

    /// Share of one core that the server takes while the clients run, %.
    double cpu_percent(double seconds) {
        const double before = cpu_seconds(pid());
        run_for(seconds);
        return 100 * (cpu_seconds(pid()) - before) / seconds;
    }

    double resident() {
        run_for(0.5);
        return resident_bytes(pid());
    }

    [[nodiscard]] std::vector<Player>& players() { return players_; }

  private:
    [[nodiscard]] pid_t pid() { return server_.process().id(); }

    e2e::TemporaryFolder folder_;
    e2e::ServerProcess server_;
    boost::asio::io_context context_;
    std::vector<Player> players_;
};

void measure_rest(const LoadSpec& spec) {
    Scene scene;
    scene.run_for(1);
    print("cpu_no_match", scene.cpu_percent(spec.seconds), "% of a core");
    scene.open_table();
    scene.run_for(1);
    print("cpu_1_idle_match", scene.cpu_percent(spec.seconds), "% of a core");
}

double messages_of(Scene& scene) {
    std::uint64_t sum = 0;
    for (const Player& player : scene.players())
        sum += player.messages();
    return static_cast<double>(sum);
}

/// Plays on, and prints what it costs under this name.
void measure_delivery(Scene& scene, const std::string& name, double seconds) {
    scene.play();
    scene.run_for(2);
    const double before = messages_of(scene);
    const double percent = scene.cpu_percent(seconds);
    const double rate = (messages_of(scene) - before) / seconds;
    print("cpu_" + name, percent, "% of a core");
    print("messages_" + name, rate, "1/s");
    print("cpu_a_message_" + name, percent / 100 / rate * 1e6, "us");
}

void measure_play(const LoadSpec& spec) {
    Scene scene;
    scene.players().reserve(2 * spec.matches);
    for (std::size_t i = 0; i < spec.matches; ++i)
        scene.open_table();
    measure_delivery(scene, std::to_string(spec.matches) + "_playing_matches", spec.seconds);
}

void measure_fan_out(const LoadSpec& spec) {
    Scene scene;
    scene.players().reserve(2 + kSpectators);
    scene.open_table();
    const std::string code = scene.players().front().code();
    for (std::size_t i = 0; i < kSpectators; ++i) {
        Player& player = scene.add(i % 2 == 0 ? Encoding::kJson : Encoding::kCbor);
        player.send(protocol::WatchMatch{code, ""});
        scene.run_until([&] { return !player.code().empty(); });
    }
    measure_delivery(scene, "1_match_" + std::to_string(kSpectators) + "_spectators", spec.seconds);
}

void measure_memory() {
    Scene scene;
    scene.players().reserve(kIdleSessions + kIdleMatches);
    const double empty = scene.resident();
    print("memory_empty_server", empty, "bytes");
    for (std::size_t i = 0; i < kIdleSessions; ++i)
        scene.add(i % 2 == 0 ? Encoding::kJson : Encoding::kCbor);
    const double with_sessions = scene.resident();
    const double session = (with_sessions - empty) / static_cast<double>(kIdleSessions);
    print("memory_a_session", session, "bytes");
    for (std::size_t i = 0; i < kIdleMatches; ++i)
        scene.open_match(Encoding::kJson);
    const double with_matches = scene.resident();
    print("memory_a_match",
          (with_matches - with_sessions) / static_cast<double>(kIdleMatches) - session, "bytes");
}

void measure_bytes() {
    struct Watcher {
        Encoding encoding;
        Stream stream;
        const char* figure;
    };

    const std::array watchers{Watcher{Encoding::kJson, Stream::kStates, "bytes_a_shot_json_states"},
                              Watcher{Encoding::kCbor, Stream::kStates, "bytes_a_shot_cbor_states"},
                              Watcher{Encoding::kJson, Stream::kShots, "bytes_a_shot_json_shots"},
                              Watcher{Encoding::kCbor, Stream::kShots, "bytes_a_shot_cbor_shots"}};
    constexpr std::uint64_t kShots = 4;
    Scene scene;
    scene.players().reserve(6);
    scene.open_table();
    const std::string code = scene.players().front().code();
    for (const Watcher& watcher : watchers) {
        Player& player = scene.add(watcher.encoding);
        player.send(protocol::WatchMatch{code, "", watcher.stream});
        scene.run_until([&] { return !player.code().empty(); });
    }
    scene.play();
    scene.run_until([&] { return scene.players().back().shots() >= kShots; });
    for (std::size_t i = 0; i < std::size(watchers); ++i) {
        const Player& player = scene.players()[2 + i];
        const auto shots = static_cast<double>(player.shots());
        print(watchers[i].figure, static_cast<double>(player.shot_traffic().bytes) / shots,
              "bytes");
        print(std::string(watchers[i].figure) + "_messages",
              static_cast<double>(player.shot_traffic().messages) / shots, "messages");
    }
}

LoadSpec parse(int argc, char** argv) {
    LoadSpec spec;
    if (argc > 1) spec.matches = std::stoul(argv[1]);
    if (argc > 2) spec.seconds = std::stod(argv[2]);
    if (argc > 3 || spec.matches < 1 || spec.matches > 2000 ||
        !(spec.seconds >= 1 && spec.seconds <= 600))
        throw std::invalid_argument("out of range");
    return spec;
}

int measure(const LoadSpec& spec) {
    print_build();
    std::puts("figure,value,unit");
    measure_rest(spec);
    measure_play(spec);
    measure_fan_out(spec);
    measure_memory();
    measure_bytes();
    return EXIT_SUCCESS;
}

}  // namespace
}  // namespace poolhall::load

int main(int argc, char** argv) {
    poolhall::load::LoadSpec spec;
    try {
        spec = poolhall::load::parse(argc, argv);
    } catch (const std::exception&) {
        std::fputs("usage: poolhall-load [MATCHES (1 to 2000; 100)] [SECONDS (1 to 600; 10)]\n",
                   stderr);
        return 2;
    }
    try {
        return poolhall::load::measure(spec);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "poolhall-load: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
