#include "client/lab/recorded/recording.hpp"

#include "protocol/tree.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

namespace poolhall::lab {

namespace {

using Json = nlohmann::ordered_json;
using Fault = std::optional<std::string>;

constexpr double kLongest = 600;     ///< s
constexpr double kTolerance = 0.02;  ///< m, of a place beyond the rails
constexpr std::size_t kMostBalls = 16;
constexpr std::size_t kLeastShots = 2;  ///< one to fit the constants to, one to report on

std::string line_of(std::string_view text, std::size_t position) {
    const std::string_view before = text.substr(0, std::min(position, text.size()));
    return std::to_string(1 + std::count(before.begin(), before.end(), '\n'));
}

/// Reads an array of numbers up to `most` in size.
Fault read_numbers(const Json& tree, const std::string& pointer, double most,
                   std::vector<double>& numbers) {
    if (!tree.is_array() || tree.empty()) return pointer + ": must be an array of numbers";
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const bool good = tree[i].is_number() && std::abs(tree[i].get<double>()) <= most;
        if (!good)
            return pointer + "/" + std::to_string(i) + ": must be a number up to " +
                   std::to_string(most).substr(0, 6) + " in size";
        numbers.push_back(tree[i].get<double>());
    }
    return std::nullopt;
}

Fault read_track(const Json& tree, const std::string& pointer, RecordedTrack& track) {
    if (!tree.is_object()) return pointer + ": must be an object";
    std::vector<double> x;
    std::vector<double> y;

    struct Field {
        const char* name;
        double most;
        std::vector<double>& numbers;
    };

    for (const Field& field :
         {Field{"t", kLongest, track.t}, Field{"x", kCaromLength / 2 + kTolerance, x},
          Field{"y", kCaromWidth / 2 + kTolerance, y}}) {
        if (!tree.contains(field.name)) return pointer + ": has no \"" + field.name + "\"";
        const std::string place = pointer + "/" + field.name;
        if (auto fault = read_numbers(tree[field.name], place, field.most, field.numbers))
            return fault;
        if (field.numbers.size() != track.t.size()) return place + ": must be as long as \"t\"";
    }
    if (track.t.front() < 0 || !std::is_sorted(track.t.begin(), track.t.end()))
        return pointer + "/t: must ascend from 0";
    for (std::size_t i = 0; i < x.size(); ++i)
        track.r.push_back({x[i], y[i]});
    return std::nullopt;
}

/// A ball that only has its first and its last place has not moved.
constexpr std::size_t kPlacesAtRest = 2;

/// The ball whose second place comes first; nothing if none moves.
std::optional<std::size_t> first_mover(const RecordedShot& shot) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < shot.tracks.size(); ++i) {
        const RecordedTrack& track = shot.tracks[i];
        if (track.t.size() <= kPlacesAtRest) continue;
        if (!first || track.t[1] < shot.tracks[*first].t[1]) first = i;
    }
    return first;
}

Fault read_shot(const Json& tree, const std::string& pointer, RecordedShot& shot) {
    if (!tree.is_object() || !tree.contains("balls") || !tree["balls"].is_object())
        return pointer + ": must be an object with \"balls\"";
    const Json& balls = tree["balls"];
    if (balls.empty() || balls.size() > kMostBalls)
        return pointer + "/balls: must be 1 to " + std::to_string(kMostBalls) + " balls";
    shot.id = tree.contains("id") ? tree["id"].dump() : pointer.substr(1);
    for (const auto& [name, ball] : balls.items()) {
        const std::string place = pointer + "/balls/" + name;
        if (auto fault = read_track(ball, place, shot.tracks.emplace_back())) return fault;
    }
    const auto cue = first_mover(shot);
    if (!cue) return pointer + "/balls: none of them moves";
    shot.cue = *cue;
    return std::nullopt;
}

}  // namespace

Result<std::vector<RecordedShot>, std::string> parse_recording(std::string_view text) {
    const auto tree = protocol::parse_tree(text, protocol::Encoding::kJson);
    if (!tree) {
        const auto& error = tree.error();
        if (!error.position) return error.reason;
        return "line " + line_of(text, *error.position - 1) + ": a syntax error";
    }
    if (!tree->is_array() || tree->size() < kLeastShots)
        return std::string("must be a JSON array of two shots or more");
    std::vector<RecordedShot> shots(tree->size());
    for (std::size_t i = 0; i < shots.size(); ++i) {
        if (auto fault = read_shot((*tree)[i], "/" + std::to_string(i), shots[i])) return *fault;
    }
    return shots;
}

Result<std::vector<RecordedShot>, std::string> read_recording(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || text.str().empty()) return file + ": cannot be read";
    auto shots = parse_recording(text.str());
    if (!shots) return file + ": " + shots.error();
    return shots;
}

}  // namespace poolhall::lab
