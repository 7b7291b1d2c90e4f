// Shows what the code says of the protocol, for tests in other languages.
//
//   protocol_samples catalog
//       {"client": {TYPE: {FIELD: required}}, "server": ..., "moves": ..., "games": ..., "parts":
//       ...,
//        "listed": {PART: {FIELD: {"unit", "default", "minimum", "maximum", ...}}},
//        "solver_kinds": [...], "models": {EFFECT: [...]}}
//   protocol_samples leaves
//       JSON Lines {"pointer": "/strike/speed", "scene": {...}}, one for each number, name and
//       choice of a scene
//   protocol_samples messages COUNT
//       JSON Lines {"from": "client" | "server", "message": {...}}
//   protocol_samples results COUNT
//       JSON Lines: a scene, its result, its result with hex floats

#include "protocol/codec/codec.hpp"
#include "protocol/codec/result_json.hpp"
#include "protocol/codec/scene_json.hpp"
#include "protocol/wire/message_fields.hpp"
#include "shared/physics/simulate.hpp"
#include "tests/protocol/random_messages.hpp"
#include "tests/protocol/types.hpp"
#include "tests/shared/scene_leaves.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace poolhall::protocol {
namespace {

using wire::Json;

template <class T>
void add_fields(Json& fields) {
    const auto add = [&](const auto& spec) {
        using Member = std::remove_cvref_t<decltype(std::invoke(spec.access, std::declval<T&>()))>;
        fields[spec.name] =
            spec.presence == wire::Presence::kRequired && !wire::kIsOptional<Member>;
    };
    std::apply([&](const auto&... specs) { (add(specs), ...); }, wire::kFields<T>);
}

template <class T>
Json fields_of(const Json& others = Json::object()) {
    Json fields = others;
    add_fields<T>(fields);
    return fields;
}

/// The fields of each alternative, by its type.
template <class Variant>
Json fields_by_type(const Json& others) {
    Json types = Json::object();
    testing::for_each_alternative(
        std::type_identity<Variant>{},
        [&]<class T>(std::type_identity<T>) { types[T::kType] = fields_of<T>(others); });
    return types;
}

/// Calls visit(name, type of its parameters) for each effect.
template <class Visit>
void for_each_effect(Visit visit) {
    const Effects effects;
    for_each_field(effects, [&]<class Effect>(const auto& field, const Effect& effect) {
        if constexpr (requires { *effect; }) {
            visit(field.name, std::type_identity<typename Effect::value_type>{});
        } else {
            visit(field.name, std::type_identity<Effect>{});
        }
    });
}

template <NamedEnum E>
Json names_of() {
    Json names = Json::array();
    for (const E value : kValues<E>)
        names.push_back(poolhall::name(value));
    return names;
}

/// The objects within messages, by their names in the schemas.
Json parts() {
    Json scene = fields_of<Scene>({{"schema", true}});
    scene["strike"] = false;
    Json parts{{"game.json",
                {{"settings", fields_of<MatchSettings>()},
                 {"stroke", fields_of<Stroke>()},
                 {"state", fields_of<GameState>()},
                 {"legal", fields_of<Legal>()},
                 {"region", fields_of<Region>()},
                 {"stroke_bounds", fields_of<StrokeBounds>()},
                 {"ruling", fields_of<Ruling>()}}},
               {"server-message.json",
                {{"table_state", fields_of<TableState>()},
                 {"seat_info", fields_of<SeatInfo>()},
                 {"live_shot", fields_of<LiveShot>()},
                 {"ball_state", fields_of<BallState>()},
                 {"event", fields_of<wire::EventForm>()},
                 {"final_ball", fields_of<wire::FinalBallForm>()},
                 {"effect_use", fields_of<analysis::EffectUse>()}}},
               {"scene.json",
                {{"", scene},
                 {"table", fields_of<Table>()},
                 {"ball_spec", fields_of<BallSpec>()},
                 {"pocket_circle", fields_of<PocketCircle>()},
                 {"mouths", fields_of<Mouths>()},
                 {"cue", fields_of<CueSpec>()},
                 {"mouth", fields_of<MouthSpec>()},
                 {"restitution_by_speed", fields_of<RestitutionBySpeed>()},
                 {"effects", fields_of<Effects>()},
                 {"friction_by_speed", fields_of<FrictionBySpeed>()},
                 {"solver", fields_of<SolverSpec>()},
                 {"ball", fields_of<SceneBall>()},
                 {"limits", fields_of<Limits>()},
                 {"strike", fields_of<wire::StrikeForm>()}}}};
    for_each_effect([&]<class Spec>(std::string_view name, std::type_identity<Spec>) {
        parts["scene.json"][name] = fields_of<Spec>();
    });
    return parts;
}

/// Of numbers: what the list of fields says of them, in the words of a schema.
void describe(Json& description, const fields::Bounds& bounds) {
    if (bounds.any) return;
    description[bounds.above_low ? "exclusiveMinimum" : "minimum"] = bounds.low;
    description["maximum"] = bounds.high;
}

template <HasFieldList T>
Json listed_fields_of() {
    Json fields = Json::object();
    T object{};
    for_each_field(object, [&](const auto& field, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        constexpr bool kNumber = std::is_same_v<Member, double>;
        if constexpr (kNumber || std::is_same_v<Member, std::optional<double>>) {
            Json& description = fields[field.name] = {{"unit", field.unit}};
            describe(description, field.bounds);
            if constexpr (kNumber) {
                if (field.may_be_left_out) description["default"] = member;
            }
        }
    });
    return fields;
}

Json listed() {
    Json parts = Json::object();
    for_each_effect([&]<class Spec>(std::string_view name, std::type_identity<Spec>) {
        parts[name] = listed_fields_of<Spec>();
    });
    parts[""] = listed_fields_of<Scene>();
    parts["table"] = listed_fields_of<Table>();
    parts["ball_spec"] = listed_fields_of<BallSpec>();
    parts["pocket_circle"] = listed_fields_of<PocketCircle>();
    parts["cue"] = listed_fields_of<CueSpec>();
    parts["restitution_by_speed"] = listed_fields_of<RestitutionBySpeed>();
    parts["friction_by_speed"] = listed_fields_of<FrictionBySpeed>();
    parts["solver"] = listed_fields_of<SolverSpec>();
    parts["ball"] = listed_fields_of<SceneBall>();
    parts["limits"] = listed_fields_of<Limits>();
    parts["strike"] = listed_fields_of<Strike>();
    return parts;
}

void print_leaves() {
    poolhall::testing::for_each_changed_leaf([](const std::string& pointer, const Scene& scene) {
        std::cout << Json{{"pointer", pointer}, {"scene", to_json(scene)}}.dump() << "\n";
    });
}

void print_catalog() {
    const Json catalog{
        {"client", fields_by_type<ClientBody>({{"type", true}, {"seq", true}})},
        {"server", fields_by_type<ServerMessage>({{"type", true}})},
        {"moves", fields_by_type<Move>({{"type", true}})},
        {"games", fields_by_type<GamePart>({{"type", true}})},
        {"parts", parts()},
        {"listed", listed()},
        {"solver_kinds", names_of<SolverKind>()},
        {"presets",
         {{"table", names_of<TablePreset>()},
          {"ball", names_of<BallSet>()},
          {"cue", names_of<CuePreset>()},
          {"effects", names_of<EffectsPreset>()}}},
        {"models", {{"ball_ball", names_of<BallBallModel>()}, {"rail", names_of<RailModel>()}}}};
    std::cout << catalog.dump() << "\n";
}

template <class Message>
void print_message(const char* from, const Message& message) {
    std::cout << R"({"from":")" << from << R"(","message":)" << encode(message, Encoding::kJson)
              << "}\n";
}

void print_messages(int count) {
    testing::Random random(7);
    for (int i = 0; i < count; ++i) {
        for (const auto& message : testing::random_client_messages(random))
            print_message("client", message);
        for (const auto& message : testing::random_server_messages(random))
            print_message("server", message);
    }
}

/// JSON Lines of scenes, each followed by its result, in decimal and in hexadecimal numbers.
void print_results(int count) {
    testing::Random random(17);
    for (int i = 0; i < count; ++i) {
        Scene scene = testing::random_scene(random, true);
        scene.limits = {10, 1000};
        const ShotTrace trace = simulate(scene, i % 2 == 0 ? 1 : 0);
        std::cout << to_json(scene).dump() << "\n";
        write_result(std::cout, trace, scene, {.cost_ns = 1});
        std::cout << "\n";
        write_result(std::cout, trace, scene, {.numbers = Numbers::kHexFloat});
        std::cout << "\n";
    }
}

void write_seed(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
}

template <class Message>
void write_message_seeds(const std::filesystem::path& folder, const std::string& side,
                         const std::vector<Message>& messages) {
    for (std::size_t i = 0; i < messages.size(); ++i) {
        const std::string number = std::to_string(i);
        write_seed(folder / (side + "_json") / number, encode(messages[i], Encoding::kJson));
        write_seed(folder / (side + "_cbor") / number, encode(messages[i], Encoding::kCbor));
    }
}

void write_seeds(const std::filesystem::path& folder) {
    testing::Random random(3);
    write_message_seeds(folder, "client", testing::random_client_messages(random));
    write_message_seeds(folder, "server", testing::random_server_messages(random));
    for (int i = 0; i < 5; ++i) {
        const Scene scene = testing::random_scene(random, random.coin());
        write_seed(folder / "scene" / std::to_string(i), to_json(scene).dump());
    }
}

}  // namespace
}  // namespace poolhall::protocol

int main(int argc, char** argv) {
    const std::string_view mode = argc > 1 ? argv[1] : "";
    if (mode == "catalog" && argc == 2) {
        poolhall::protocol::print_catalog();
    } else if (mode == "leaves" && argc == 2) {
        poolhall::protocol::print_leaves();
    } else if (mode == "messages" && argc == 3) {
        poolhall::protocol::print_messages(std::atoi(argv[2]));
    } else if (mode == "results" && argc == 3) {
        poolhall::protocol::print_results(std::atoi(argv[2]));
    } else if (mode == "seeds" && argc == 3) {
        poolhall::protocol::write_seeds(argv[2]);
    } else {
        std::cerr << "usage: protocol_samples catalog | leaves | messages COUNT | results COUNT | "
                     "seeds FOLDER\n";
        return 2;
    }
    return 0;
}
