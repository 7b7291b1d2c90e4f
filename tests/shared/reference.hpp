#pragma once

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace poolhall::testing {

/// A case of reference/closed_forms.json: inputs as exact doubles, results as decimals of 45
/// digits.
struct ReferenceCase {
    std::string group;
    std::string id;
    nlohmann::json inputs;
    nlohmann::json expect;

    [[nodiscard]] bool has(const char* name) const { return inputs.contains(name); }

    [[nodiscard]] double input(const char* name) const { return exact(inputs.at(name)); }

    [[nodiscard]] double input(const char* name, std::size_t i) const {
        return exact(inputs.at(name).at(i));
    }

    /// The nearest double to the expected number.
    [[nodiscard]] double expected(const char* name) const { return nearest(expect.at(name)); }

    [[nodiscard]] double expected(const char* name, std::size_t i) const {
        return nearest(expect.at(name).at(i));
    }

  private:
    static double exact(const nlohmann::json& number) {
        return std::strtod(number.at("hex").get<std::string>().c_str(), nullptr);
    }

    static double nearest(const nlohmann::json& number) {
        return std::strtod(number.get<std::string>().c_str(), nullptr);
    }
};

/// A file of the folder reference/.
inline nlohmann::json reference_file(const std::string& name) {
    std::ifstream file(std::string(POOLHALL_REFERENCE_FOLDER "/") + name);
    return nlohmann::json::parse(file);
}

/// All cases of a group.
inline std::vector<ReferenceCase> reference_cases(const std::string& group) {
    const nlohmann::json all = reference_file("closed_forms.json");
    std::vector<ReferenceCase> cases;
    for (const nlohmann::json& one : all.at("cases")) {
        if (one.at("group") != group) continue;
        cases.push_back({group, one.at("id"), one.at("inputs"), one.at("expect")});
    }
    return cases;
}

/// The case of that group and id.
inline ReferenceCase reference_case(const std::string& group, const std::string& id) {
    for (ReferenceCase& one : reference_cases(group)) {
        if (one.id == id) return one;
    }
    throw std::out_of_range(group + " has no case " + id);
}

}  // namespace poolhall::testing
