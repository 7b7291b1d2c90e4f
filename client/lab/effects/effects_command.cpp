#include "client/lab/effects/effects_command.hpp"

#include "client/lab/effects/callgrind.hpp"
#include "client/lab/effects/effect_cases.hpp"
#include "client/lab/effects/effect_prices.hpp"
#include "client/lab/effects/effects_results.hpp"
#include "client/lab/effects/play_calls.hpp"
#include "client/lab/output/result_files.hpp"
#include "client/lab/run/long_run.hpp"
#include "client/lab/run/progress.hpp"
#include "shared/analysis/agreement.hpp"
#include "shared/physics/simulate.hpp"

#include <algorithm>
#include <optional>

namespace poolhall::lab {

namespace {

constexpr std::size_t kShots = 200;
constexpr std::size_t kQuickShots = 20;

/// The same shots without the effect, or with it at zero strength. Without friction they might have
/// no end, so they are cut off when those with it are at rest.
std::vector<Scene> weaker(std::vector<Scene> shots, ChangeScene change,
                          const std::vector<ShotTrace>& present) {
    for (std::size_t i = 0; i < shots.size(); ++i) {
        change(shots[i]);
        shots[i].limits.time = std::max(present[i].duration, 1e-3);
    }
    return shots;
}

std::vector<ShotTrace> traces_of(const std::vector<Scene>& shots) {
    std::vector<ShotTrace> traces(shots.size());
    Simulator simulator;
    for (std::size_t i = 0; i < shots.size(); ++i)
        simulator.simulate(shots[i], 0, traces[i]);
    return traces;
}

bool are_same(const std::vector<ShotTrace>& a, const std::vector<ShotTrace>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const ShotTrace& x, const ShotTrace& y) { return x.hash == y.hash; });
}

/// What the effect does to the outcome.
void compare_outcomes(const std::vector<ShotTrace>& present, const std::vector<ShotTrace>& absent,
                      EffectRow& row) {
    std::vector<double> changes;
    std::size_t flips = 0;
    for (std::size_t i = 0; i < present.size(); ++i) {
        changes.push_back(analysis::farthest_at_rest(present[i], absent[i]));
        if (!analysis::is_same_verdict(present[i], absent[i])) ++flips;
    }
    row.verdict_flips = static_cast<double>(flips) / static_cast<double>(present.size());
    row.rest_change = *spread_of(std::move(changes));
}

class EffectsRun {
  public:
    EffectsRun(const EffectsOptions& options, std::ostream& out, std::ostream& error)
        : plan_(options.plan), out_(out), progress_(error, options.bar) {
        if (!options.counted.empty()) callgrind_.emplace(options.counted);
    }

    /// Whether instructions can be counted as asked for; fault() says why not.
    bool can_count() {
        if (callgrind_)
            (void)callgrind_->instructions_of(
                changed_scenes("one_ball", plan_.seed, 1, [](Scene&) {}));
        return !fault();
    }

    EffectsResult run() {
        result_.command = command_line("effects", plan_) + (callgrind_ ? " --callgrind" : "");
        result_.seed = plan_.seed;
        result_.shots = plan_.shots > 0 ? plan_.shots : plan_.quick ? kQuickShots : kShots;
        result_.build = build_info();
        print_head(out_, result_.command, result_.build);
        result_.complete = run_kernels() && run_effects() && run_play();
        progress_.clear();
        return std::move(result_);
    }

    /// The effect of which shots without it and shots with it at zero strength differ; empty if
    /// none does.
    [[nodiscard]] const std::string& wrong() const { return wrong_; }

    /// Why instructions could not be counted.
    [[nodiscard]] std::optional<std::string> fault() const {
        return callgrind_ ? callgrind_->fault() : std::nullopt;
    }

  private:
    ShotPrices prices(const std::vector<Scene>& shots) {
        return prices_of(shots, plan_.repeats(), callgrind_ ? &*callgrind_ : nullptr);
    }

    /// Then what was begun is not finished.
    [[nodiscard]] bool is_over() const { return Interruption::asked_for() || fault(); }

    [[nodiscard]] std::vector<Scene> scenes(std::string_view ensemble, ChangeScene change) const {
        return changed_scenes(ensemble, plan_.seed, result_.shots, change);
    }

    /// False if it is over.
    bool run_kernels() {
        progress_.begin("kernels", kernel_cases().size());
        for (const KernelCase& one : kernel_cases()) {
            const std::vector<Scene> shots = scenes(one.ensemble, one.change);
            KernelRow row{std::string(one.kernel), std::string(one.ensemble), prices(shots),
                          price_by("everything", shots, plan_.repeats())};
            if (is_over()) return false;
            result_.kernels.push_back(std::move(row));
            progress_.step();
        }
        progress_.clear();
        print_kernels(out_, result_.kernels);
        return true;
    }

    /// False if it is over, or an effect is wrong.
    bool run_effects() {
        progress_.begin("effects", effect_cases().size());
        for (const EffectCase& one : effect_cases()) {
            if (!run_effect(one)) return false;
            progress_.step();
        }
        progress_.clear();
        print_effects(out_, result_.effects);
        return true;
    }

    /// False if it is over.
    bool run_play() {
        progress_.begin("play", kinds_of_play().size());
        for (const PlayKind& kind : kinds_of_play()) {
            PlayRow row = measure_play(kind, plan_.seed, result_.shots, plan_.repeats());
            if (is_over()) return false;
            result_.play.push_back(std::move(row));
            progress_.step();
        }
        progress_.clear();
        print_play(out_, result_.play);
        return true;
    }

    bool run_effect(const EffectCase& one) {
        EffectRow row{std::string(one.effect), std::string(one.ensemble), {}, {}, {}, {}, 0};
        const std::vector<Scene> present = scenes(one.ensemble, one.present);
        const std::vector<ShotTrace> traces = traces_of(present);
        const std::vector<Scene> absent = weaker(present, one.absent, traces);
        const std::vector<ShotTrace> without = traces_of(absent);
        compare_outcomes(traces, without, row);
        row.present = prices(present);
        row.absent = prices(absent);
        if (one.zero) {
            const std::vector<Scene> zero = weaker(present, one.zero, traces);
            if (!are_same(without, traces_of(zero))) {
                wrong_ = row.effect;
                return false;
            }
            row.zero = prices(zero);
        }
        if (is_over()) return false;
        result_.effects.push_back(std::move(row));
        return true;
    }

    const RunPlan& plan_;
    std::ostream& out_;
    Progress progress_;
    std::optional<Callgrind> callgrind_;
    EffectsResult result_;
    std::string wrong_;
};

}  // namespace

Status measure_effects(const EffectsOptions& options, std::ostream& out, std::ostream& error) {
    ResultFiles files(options.out, "effects");
    if (files.fault()) return fail(error, *files.fault());
    const Interruption interruption;
    EffectsRun run(options, out, error);
    if (!run.can_count()) return fail(error, *run.fault());
    const EffectsResult result = run.run();
    if (run.fault()) return fail(error, *run.fault());
    if (!run.wrong().empty()) {
        error << "poolhall-lab: " << run.wrong()
              << ": shots without it and with it at zero strength differ\n";
        return Status::kWrong;
    }
    files.write([&](std::ostream& json) { write_json(json, result); },
                [&](std::ostream& csv) { write_csv(csv, result); });
    if (files.fault()) return fail(error, *files.fault());
    return result.complete ? Status::kGood : say_interrupted(error, options.out);
}

}  // namespace poolhall::lab
