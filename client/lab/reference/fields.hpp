#pragma once

#include "client/lab/reference/simulation_113.hpp"
#include "shared/fields.hpp"
#include "shared/physics/scene/scene.hpp"
#include "shared/physics/scene/trace.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

// How scenes and traces are written to a tape and read from it, by their lists of fields; both
// compilations include this, so that what one writes the other reads. Names of balls and circles
// stay behind.
namespace poolhall::lab {

/// Appends what it is given.
class TapeWriter {
  public:
    /// The tape is overwritten.
    explicit TapeWriter(poolhall_reference::Tape& tape) : tape_(tape) { tape_.clear(); }

    template <HasFieldList T>
    void operator()(const T& object) {
        write(object);
    }

  private:
    void write(Real x) {
        const auto value = static_cast<double>(x);
        tape_.push_back({value, static_cast<double>(x - value)});
    }

    template <class T>
    requires std::is_enum_v<T> || std::integral<T>

    void write(T x) { tape_.push_back({static_cast<double>(x), 0}); }

    template <class T>
    void write(const std::optional<T>& x) {
        write(x.has_value());
        if (x) write(*x);
    }

    template <class T, std::size_t kSize>
    void write(const std::array<T, kSize>& all) {
        for (const T& x : all)
            write(x);
    }

    template <class T>
    void write(const std::vector<T>& all) {
        write(all.size());
        for (const T& x : all)
            write(x);
    }

    void write(const std::string& /*name*/) {}

    void write(BallIndex x) { write(x.value); }

    void write(const Vec2& a) {
        write(a.x);
        write(a.y);
    }

    void write(const Vec3& a) {
        write(xy(a));
        write(a.z);
    }

    template <HasFieldList T>
    void write(const T& x) {
        for_each_field(x, [this](const auto&, const auto& member) { this->write(member); });
    }

    poolhall_reference::Tape& tape_;
};

/// Takes fields from a tape, in the order in which they were written.
class TapeReader {
  public:
    /// What of its numbers is read into a Real. Counts and names are whole in their values.
    enum class Part { kValue, kRest, kSum };

    TapeReader(const poolhall_reference::Tape& tape, Part part) : tape_(tape), part_(part) {}

    template <HasFieldList T>
    void operator()(T& object) {
        read(object);
    }

  private:
    void read(Real& x) {
        const auto& [value, rest] = tape_[next_++];
        x = part_ == Part::kSum ? Real{value} + rest : part_ == Part::kRest ? rest : value;
    }

    template <class T>
    requires std::is_enum_v<T> || std::integral<T>

    void read(T& x) { x = static_cast<T>(static_cast<std::int64_t>(tape_[next_++].value)); }

    template <class T>
    void read(std::optional<T>& x) {
        bool has_value = false;
        read(has_value);
        x.reset();
        if (has_value) read(x.emplace());
    }

    template <class T, std::size_t kSize>
    void read(std::array<T, kSize>& all) {
        for (T& x : all)
            read(x);
    }

    template <class T>
    void read(std::vector<T>& all) {
        std::size_t size = 0;
        read(size);
        all.resize(size);
        for (T& x : all)
            read(x);
    }

    void read(std::string& /*name*/) {}

    void read(BallIndex& x) { read(x.value); }

    void read(Vec2& a) {
        read(a.x);
        read(a.y);
    }

    void read(Vec3& a) {
        read(a.x);
        read(a.y);
        read(a.z);
    }

    template <HasFieldList T>
    void read(T& x) {
        for_each_field(x, [this](const auto&, auto& member) { this->read(member); });
    }

    const poolhall_reference::Tape& tape_;
    Part part_;
    std::size_t next_ = 0;
};

}  // namespace poolhall::lab
