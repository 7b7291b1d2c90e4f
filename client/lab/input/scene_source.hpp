#pragma once

#include "client/lab/input/line_reader.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/result.hpp"

#include <cstddef>
#include <deque>
#include <fstream>
#include <istream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace poolhall::lab {

/// A JSON value of the input, or why there is none.
struct SceneText {
    std::size_t line = 0;  ///< where it begins, or where it is wrong; from 1
    Result<nlohmann::ordered_json, std::string> tree;
};

/// Takes scenes one by one from JSON Lines, or the one scene from a file that spreads it over many
/// lines. The input is taken for one object if its first line is the beginning of one, unless a
/// line further on is a scene by itself.
class SceneSource {
  public:
    explicit SceneSource(std::istream& in) : reader_(in) {}

    /// Nothing at the end of the input. Blank lines are skipped.
    [[nodiscard]] std::optional<SceneText> next();

  private:
    struct Line {
        std::size_t number = 0;
        std::string text;
        bool too_long = false;
    };

    [[nodiscard]] std::optional<Line> next_line();
    /// The object that begins on the given line, to the end of the input; nothing if the input
    /// turns out to be JSON Lines, of which the lines read so far are then put back.
    [[nodiscard]] std::optional<SceneText> read_object(Line first);
    void put_back(std::deque<Line> lines);

    LineReader reader_;
    std::deque<Line> put_back_;
    bool is_lines_ = false;  ///< known to be JSON Lines
    bool ended_ = false;     ///< the rest belongs to an object that is too long
};

/// The file, opened to be read; "FILE is a folder" or "FILE cannot be opened" otherwise.
[[nodiscard]] Result<std::ifstream, std::string> open_scenes(const std::string& file);

/// "/balls/1/r: overlaps /balls/0".
[[nodiscard]] std::string text_of(const SceneError& fault);

}  // namespace poolhall::lab
