#include "client/lab/input/scene_source.hpp"

#include "protocol/tree.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

namespace poolhall::lab {

namespace {

using protocol::Encoding;
using protocol::TreeError;
using Json = nlohmann::ordered_json;

bool is_blank(std::string_view text) {
    return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

/// Whether the text was a good beginning.
bool is_unfinished(const TreeError& error, std::string_view text) {
    return error.position && *error.position > text.size();
}

/// Whether the line is a scene, rather than a part of one.
bool is_scene(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string::npos || text[begin] != '{') return false;
    if (text.find("\"schema\"") == std::string::npos) return false;
    const auto tree = protocol::parse_tree(text, Encoding::kJson);
    return tree && tree->is_object() && tree->contains("schema");
}

std::string too_long() {
    return "is longer than " + std::to_string(LineReader::kMaxLineBytes >> 20U) + " MiB";
}

/// What is wrong, by the line that it is on; `text` begins on line `first`.
SceneText located(const TreeError& error, std::string_view text, std::size_t first) {
    if (!error.position) return {first, error.reason};
    const std::string_view before = text.substr(0, std::min(*error.position, text.size() + 1) - 1);
    const auto newlines = std::count(before.begin(), before.end(), '\n');
    const std::size_t line_begin = newlines == 0 ? 0 : before.rfind('\n') + 1;
    return {first + static_cast<std::size_t>(newlines),
            "a syntax error at byte " + std::to_string(*error.position - line_begin) +
                (is_unfinished(error, text) ? ", the end" : "")};
}

}  // namespace

std::optional<SceneText> SceneSource::next() {
    while (!ended_) {
        auto line = next_line();
        if (!line) break;
        if (line->too_long) return SceneText{line->number, too_long()};
        auto tree = protocol::parse_tree(line->text, Encoding::kJson);
        if (tree) {
            is_lines_ = true;
            return SceneText{line->number, std::move(*tree)};
        }
        if (is_lines_ || !is_unfinished(tree.error(), line->text))
            return located(tree.error(), line->text, line->number);
        if (auto object = read_object(*std::move(line))) return object;
    }
    return std::nullopt;
}

std::optional<SceneSource::Line> SceneSource::next_line() {
    if (!put_back_.empty()) {
        Line line = std::move(put_back_.front());
        put_back_.pop_front();
        return line;
    }
    std::string text;
    for (;;) {
        const LineReader::Got got = reader_.next(text);
        if (got == LineReader::Got::kEnd) return std::nullopt;
        if (got == LineReader::Got::kTooLong) return Line{reader_.number(), {}, true};
        if (!is_blank(text)) return Line{reader_.number(), std::move(text), false};
    }
}

std::optional<SceneText> SceneSource::read_object(Line first) {
    const std::size_t begin = first.number;
    std::string text = first.text;
    std::size_t lines = 1;
    std::deque<Line> read;
    read.push_back(std::move(first));
    while (auto line = next_line()) {
        const bool known = line->too_long || is_scene(line->text);
        text.append(line->number - begin - lines + 1, '\n').append(line->text);
        lines = line->number - begin + 1;
        read.push_back(*std::move(line));
        if (known) {
            put_back(std::move(read));
            return std::nullopt;
        }
        if (text.size() > LineReader::kMaxLineBytes) {
            ended_ = true;
            return SceneText{begin, too_long()};
        }
    }
    auto tree = protocol::parse_tree(text, Encoding::kJson);
    if (!tree) return located(tree.error(), text, begin);
    return SceneText{begin, std::move(*tree)};
}

void SceneSource::put_back(std::deque<Line> lines) {
    is_lines_ = true;
    put_back_ = std::move(lines);
}

Result<std::ifstream, std::string> open_scenes(const std::string& file) {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) return file + " is a folder";
    std::ifstream in(file, std::ios::binary);
    if (!in) return file + " cannot be opened";
    return in;
}

std::string text_of(const SceneError& fault) {
    return fault.pointer.empty() ? "the scene " + fault.reason
                                 : fault.pointer + ": " + fault.reason;
}

}  // namespace poolhall::lab
