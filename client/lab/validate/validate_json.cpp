#include "client/lab/output/result_json.hpp"
#include "client/lab/validate/validate_results.hpp"

namespace poolhall::lab {

namespace {

using lab::json_of;

Json json_of(const MeasuredTable& table, const MeasuredRow& row) {
    Json ours = Json::array();
    Json errors = Json::array();
    for (std::size_t model = 0; model < table.models.size(); ++model) {
        ours.push_back(json_of(row.ours[model]));
        errors.push_back(json_of(error_of(table, row, model)));
    }
    return {{"what", row.what},
            {"published", {row.published.low, row.published.high}},
            {"outlier", row.is_outlier},
            {"ours", ours},
            {"errors", errors}};
}

Json json_of(const MeasuredTable& table) {
    Json rows = Json::array();
    for (const MeasuredRow& row : table.rows)
        rows.push_back(json_of(table, row));
    Json rms = Json::array();
    Json without = Json::array();
    for (std::size_t model = 0; model < table.models.size(); ++model) {
        const TableErrors errors = errors_of(table, model);
        rms.push_back(json_of(errors.rms));
        without.push_back(json_of(errors.rms_without_outliers));
    }
    return {{"name", table.name},
            {"title", table.title},
            {"unit", table.unit},
            {"source", table.source},
            {"accuracy", table.accuracy},
            {"relative", table.is_relative},
            {"digits", table.digits},
            {"reach", json_of(table.reach)},
            {"note", table.note},
            {"models", table.models},
            {"rows", rows},
            {"rms", rms},
            {"rms_without_outliers", without}};
}

Json json_of(const Figure& figure) {
    Json curves = Json::array();
    for (const Curve& curve : figure.curves)
        curves.push_back({{"label", curve.label},
                          {"published", curve.is_published},
                          {"points", curve.is_points},
                          {"x", curve.x},
                          {"y", curve.y}});
    return {{"name", figure.name}, {"title", figure.title}, {"note", figure.note},
            {"x", figure.x},       {"y", figure.y},         {"curves", curves}};
}

Json json_of(const Unknown& one) {
    return {{"ensemble", one.ensemble},
            {"shots", one.shots},
            {"placement", json_of(std::optional(one.placement))},
            {"coefficients", json_of(std::optional(one.coefficients))}};
}

Json json_of(const HorizonByError& one) {
    return {{"ensemble", one.ensemble},
            {"shots", one.shots},
            {"input_error", one.input_error},
            {"horizon", one.horizon},
            {"duration", one.duration}};
}

Json json_of(const Quartiles& quartiles) {
    return {{"p25", quartiles.p25}, {"median", quartiles.median}, {"p75", quartiles.p75}};
}

Json json_of(const ShotsFound& found) {
    return {{"shots", found.shots},
            {"whole", json_of(found.whole)},
            {"to_third_rail", json_of(found.to_third_rail)}};
}

Json json_of(const RecordedResult& one) {
    Json constants = Json::object();
    for (const auto& [name, value] : one.constants)
        constants[name] = value;
    return {
        {"model", one.model},      {"constants", constants},    {"unfitted", json_of(one.unfitted)},
        {"odd", json_of(one.odd)}, {"even", json_of(one.even)}, {"seconds", one.seconds}};
}

template <class Row>
Json list_of(const std::vector<Row>& rows) {
    Json json = Json::array();
    for (const Row& row : rows)
        json.push_back(json_of(row));
    return json;
}

}  // namespace

void write_json(std::ostream& out, const ValidateResult& result) {
    const Json json{{"schema", "poolhall.validate/1"},
                    {"command", result.command},
                    {"complete", result.complete},
                    {"build", json_of(result.build)},
                    {"tables", list_of(result.tables)},
                    {"figures", list_of(result.figures)},
                    {"unknowns", list_of(result.unknowns)},
                    {"horizons", list_of(result.horizons)},
                    {"recorded_shots", result.recorded_shots},
                    {"recorded", list_of(result.recorded)}};
    out << json.dump(1) << '\n';
}

}  // namespace poolhall::lab
