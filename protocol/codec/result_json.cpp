#include "protocol/codec/result_json.hpp"

#include "protocol/text.hpp"
#include "protocol/wire/shot_fields.hpp"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace poolhall::protocol {
namespace {

using wire::Json;

Json state_json(const BallState& state) {
    return wire::Object<BallState>{}.write(state, Encoding::kJson);
}

/// {"cue": {"r", "v", "w"}, ...}.
Json states_json(const ShotEvent& event, const std::array<BallState, 2>& states,
                 const Scene& scene) {
    Json object = Json::object();
    for (std::size_t i = 0; i < event.ball_count; ++i)
        object[scene.balls[event.balls[i].value].id] = state_json(states[i]);
    return object;
}

/// Where an event happened: the ball's centre, or the point between two.
Json place_json(const ShotEvent& event) {
    Vec2 at = xy(event.before[0].r);
    if (event.ball_count == 2) at = 0.5 * (at + xy(event.before[1].r));
    return Json::array({at.x, at.y});
}

Json head_json(const ShotTrace& trace, const Scene& scene) {
    return {
        {"schema", "poolhall.result/1"},
        {"id", scene.id},
        {"solver", name(trace.solver)},
        {"kernel", trace.kernel},
        {"effects", wire::kEffectUses.write(analysis::effect_uses(scene, trace), Encoding::kJson)},
        {"hash", to_hex(trace.hash)},
        {"duration", trace.duration},
        {"outcome", name(trace.outcome)}};
}

Json ball_json(const FinalBall& ball, const std::string& id, const Table& table) {
    Json object{{"id", id}, {"motion", name(ball.motion)}};
    if (ball.motion == Motion::kPocketed) object["pocket"] = pocket_id(table, ball.pocket);
    object.update(state_json(ball.state));
    return object;
}

Json sample_json(const ShotTrace& trace, std::size_t k) {
    Json places = Json::array();
    for (std::size_t i = 0; i < trace.balls.size(); ++i) {
        const Vec3& r = trace.sample(k, i);
        places.push_back(Json::array({r.x, r.y, r.z}));
    }
    return {{"t", static_cast<double>(k) / trace.sample_hz}, {"r", std::move(places)}};
}

void spell_in_hex(Json& tree) {
    if (tree.is_number_float()) tree = to_hex_float(tree.get<double>());
    if (!tree.is_structured()) return;
    for (Json& part : tree)
        spell_in_hex(part);
}

/// Writes trees, their numbers as asked for.
class TreeWriter {
  public:
    TreeWriter(std::ostream& out, Numbers numbers) : out_(out), numbers_(numbers) {}

    void write(Json tree) { out_ << text_of(std::move(tree)); }

    /// ,"key":[make(0),make(1),...]
    template <class Make>
    void write_list(std::string_view key, std::size_t count, Make make) {
        out_ << ",\"" << key << "\":[";
        for (std::size_t i = 0; i < count; ++i) {
            if (i > 0) out_ << ',';
            write(make(i));
        }
        out_ << ']';
    }

    /// The tree's fields, without the brace that closes them.
    void open(Json object) {
        const std::string text = text_of(std::move(object));
        out_ << std::string_view(text).substr(0, text.size() - 1);
    }

  private:
    [[nodiscard]] std::string text_of(Json tree) const {
        if (numbers_ == Numbers::kHexFloat) spell_in_hex(tree);
        return tree.dump(-1, ' ', false, Json::error_handler_t::replace);
    }

    std::ostream& out_;
    Numbers numbers_;
};

}  // namespace

Json to_json(const ShotEvent& event, const Scene& scene) {
    Json ids = Json::array();
    for (std::size_t i = 0; i < event.ball_count; ++i)
        ids.push_back(scene.balls[event.balls[i].value].id);
    Json object{{"t", event.t}, {"kind", name(event.kind)}, {"balls", std::move(ids)}};
    if (event.kind == EventKind::kBallRail) object["rail"] = name(event.rail);
    if (event.kind == EventKind::kBallPocket)
        object["pocket"] = pocket_id(scene.table, event.pocket);
    object["at"] = place_json(event);
    object["before"] = states_json(event, event.before, scene);
    object["after"] = states_json(event, event.after, scene);
    return object;
}

void write_result(std::ostream& out, const ShotTrace& trace, const Scene& scene,
                  const ResultForm& form) {
    TreeWriter writer(out, form.numbers);
    writer.open(head_json(trace, scene));
    writer.write_list("events", trace.events.size(),
                      [&](std::size_t i) { return to_json(trace.events[i], scene); });
    writer.write_list("balls", trace.balls.size(), [&](std::size_t i) {
        return ball_json(trace.balls[i], scene.balls[i].id, scene.table);
    });
    if (form.cost_ns) {
        out << ",\"cost\":";
        writer.write(
            {{"ns", *form.cost_ns}, {"ticks", trace.ticks}, {"events", trace.events.size()}});
    }
    if (trace.sample_hz > 0) {
        writer.write_list("samples", trace.sample_count(),
                          [&](std::size_t k) { return sample_json(trace, k); });
    }
    out << '}';
}

}  // namespace poolhall::protocol
