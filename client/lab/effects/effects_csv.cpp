#include "client/lab/effects/effects_results.hpp"
#include "client/lab/output/csv_line.hpp"

#include <iomanip>
#include <limits>

namespace poolhall::lab {

namespace {

void put(CsvLine& line, const std::optional<Price>& price) {
    line << (price ? std::optional(price->ns) : std::nullopt)
         << (price ? price->instructions : std::nullopt);
}

void put(CsvLine& line, const ShotPrices& prices) {
    put(line, std::optional(prices.per_shot));
    put(line, std::optional(prices.per_event));
    put(line, prices.per_ball_step);
}

void write_variant(std::ostream& out, const EffectRow& row, const char* variant,
                   const ShotPrices& prices) {
    CsvLine line(out);
    line << "effect" << row.effect << row.ensemble << variant;
    put(line, prices);
    line << row.rest_change << row.verdict_flips;
    out << '\n';
}

void write_play(std::ostream& out, const PlayRow& row, const char* variant, const Price& price) {
    CsvLine line(out);
    line << "play" << row.kind << "real_play" << variant;
    put(line, std::optional(price));
    put(line, std::optional<Price>());
    put(line, std::optional<Price>());
    line << std::optional<Spread>() << std::optional<double>();
    out << '\n';
}

}  // namespace

void write_csv(std::ostream& out, const EffectsResult& result) {
    out << std::setprecision(std::numeric_limits<double>::max_digits10)
        << "part,name,ensemble,variant,shot_ns,shot_instructions,event_ns,event_instructions,"
           "ball_step_ns,ball_step_instructions,rest_change_median,rest_change_p90,"
           "rest_change_max,verdict_flips\n";
    for (const KernelRow& row : result.kernels) {
        CsvLine line(out);
        line << "kernel" << row.kernel << row.ensemble << "own";
        put(line, row.prices);
        line << std::optional<Spread>() << std::optional<double>();
        out << '\n';
    }
    for (const EffectRow& row : result.effects) {
        write_variant(out, row, "absent", row.absent);
        if (row.zero) write_variant(out, row, "zero", *row.zero);
        write_variant(out, row, "present", row.present);
    }
    for (const PlayRow& row : result.play) {
        write_play(out, row, "called_for", row.per_shot);
        write_play(out, row, "everything", row.by_everything);
    }
}

}  // namespace poolhall::lab
