#include "client/compare/number_text.hpp"
#include "client/lab/effects/effects_results.hpp"
#include "client/lab/output/columns.hpp"

namespace poolhall::lab {

namespace {

using compare::formatted;
using compare::text_of_cost;
using compare::text_of_distance;

std::string small_cost(double ns) {
    return formatted("%.1f ns", ns);
}

std::string instructions_of(const Price& price) {
    return price.instructions ? formatted("%.0f", *price.instructions) : "-";
}

/// CPU time and instructions of a shot, of an event, of a ball's step.
void append_prices(const ShotPrices& prices, std::vector<std::string>& line) {
    line.insert(line.end(), {text_of_cost(prices.per_shot.ns), instructions_of(prices.per_shot),
                             small_cost(prices.per_event.ns), instructions_of(prices.per_event)});
    if (prices.per_ball_step) {
        line.push_back(small_cost(prices.per_ball_step->ns));
        line.push_back(instructions_of(*prices.per_ball_step));
    } else {
        line.insert(line.end(), 2, "-");
    }
}

void add_variant(const EffectRow& row, const char* variant, const ShotPrices& prices,
                 Columns& table) {
    std::vector<std::string> line{row.effect, row.ensemble, variant};
    append_prices(prices, line);
    if (&prices == &row.present) {
        for (const double change :
             {row.rest_change.median, row.rest_change.p90, row.rest_change.max})
            line.push_back(text_of_distance(change));
        line.push_back(formatted("%.1f %%", 100 * row.verdict_flips));
    }
    table.add(std::move(line));
}

}  // namespace

void print_kernels(std::ostream& out, const std::vector<KernelRow>& rows) {
    out << "\nKernels, each on shots that call for just its effects\n\n";
    Columns table;
    table.add({"kernel", "shots", "CPU/shot", "instr.", "event", "instr.", "ball-step", "instr.",
               "by everything"});
    for (const KernelRow& row : rows) {
        std::vector<std::string> line{row.kernel, row.ensemble};
        append_prices(row.prices, line);
        line.push_back(text_of_cost(row.by_everything.ns));
        table.add(std::move(line));
    }
    table.print(out);
}

void print_effects(std::ostream& out, const std::vector<EffectRow>& rows) {
    out << "\nEffects, and how far balls come to rest from where they would without\n\n";
    Columns table;
    table.add({"effect", "shots", "", "CPU/shot", "instr.", "event", "instr.", "ball-step",
               "instr.", "median", "90 %", "max", "verdict flips"});
    for (const EffectRow& row : rows) {
        add_variant(row, "absent", row.absent, table);
        if (row.zero) add_variant(row, "zero", *row.zero, table);
        add_variant(row, "present", row.present, table);
    }
    table.print(out);
}

/// A column for each kind of play.
void print_play(std::ostream& out, const std::vector<PlayRow>& rows) {
    if (rows.empty()) return;
    out << "\nShots of real play that call for an effect (of those, shots in which it acts)\n\n";
    Columns table;
    std::vector<std::string> head{"effect"};
    std::vector<std::string> saved{"saved"};
    for (const PlayRow& row : rows) {
        head.push_back(row.kind);
        saved.push_back(formatted("%.1f %%", 100 * (1 - row.per_shot.ns / row.by_everything.ns)));
    }
    table.add(std::move(head));
    for (std::size_t i = 0; i < rows[0].effects.size(); ++i) {
        std::vector<std::string> line{rows[0].effects[i].effect};
        for (const PlayRow& row : rows)
            line.push_back(formatted("%.1f %%", 100 * row.effects[i].called_for) +
                           formatted(" (%.1f %%)", 100 * row.effects[i].acted));
        table.add(std::move(line));
    }
    table.add(std::move(saved));
    table.print(out);
}

}  // namespace poolhall::lab
