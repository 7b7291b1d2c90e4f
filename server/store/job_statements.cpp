#include "server/store/job_statements.hpp"

#include "protocol/replay/line.hpp"
#include "protocol/replay/record_text.hpp"

#include <SQLiteCpp/Column.h>
#include <SQLiteCpp/VariadicBind.h>
#include <cassert>

namespace poolhall::server {

namespace {

template <class... Values>
void execute(SQLite::Statement& statement, const Values&... values) {
    statement.reset();
    SQLite::bind(statement, values...);
    statement.exec();
}

std::string no_open_match(const std::string& id) {
    return "there is no open match " + id;
}

}  // namespace

JobStatements::JobStatements(SQLite::Database& database)
    : database_(database),
      find_open_(database,
                 "SELECT num, (SELECT coalesce(max(n), 0) FROM records WHERE match = matches.num) "
                 "FROM matches WHERE id = ? AND closed_ms IS NULL"),
      is_taken_(database,
                "SELECT count(*) FROM matches WHERE id = ? OR (code = ? AND closed_ms IS NULL)"),
      create_(database, "INSERT INTO matches (id, code, game, created_ms) VALUES (?, ?, ?, ?)"),
      set_seat_(database,
                "INSERT INTO seats (match, seat, name, last_name, token_hash) VALUES (?1, ?2, ?3, "
                "?3, ?4) "
                "ON CONFLICT DO UPDATE SET name = ?3, token_hash = ?4, "
                "last_name = CASE ?3 WHEN '' THEN last_name ELSE ?3 END, "
                "wins = CASE ?3 WHEN '' THEN wins ELSE 0 END"),
      append_(database, "INSERT INTO records (match, n, kind, body, sum) VALUES (?, ?, ?, ?, ?)"),
      count_shot_(database, "UPDATE matches SET shots = shots + 1 WHERE num = ?"),
      count_game_(database, "UPDATE matches SET games = games + 1 WHERE num = ?"),
      count_win_(database, "UPDATE seats SET wins = wins + 1 WHERE match = ? AND seat = ?"),
      close_(database, "UPDATE matches SET closed_ms = ? WHERE num = ?") {}

JobFailure JobStatements::apply(const StoreJob& job) {
    return std::visit([this](const auto& alternative) { return apply_job(alternative); }, job);
}

JobFailure JobStatements::apply_job(const CreateMatchJob& job) {
    const protocol::MatchRecord& record = job.record;
    if (!protocol::is_match_id(record.match))
        return "a match id must be 1 to 64 letters, digits, _ or -";
    if (is_taken(record.match, job.code))
        return "match " + record.match + " or its code exists already";
    execute(create_, record.match, job.code, record.game, record.created_ms);
    append({database_.getLastInsertRowid(), 1}, record);
    return std::nullopt;
}

JobFailure JobStatements::apply_job(const SetSeatJob& job) {
    const auto match = find_open(job.match);
    if (!match) return no_open_match(job.match);
    execute(set_seat_, match->num, std::int32_t{job.record.seat.value}, job.record.name,
            job.token_hash);
    append(*match, job.record);
    return std::nullopt;
}

JobFailure JobStatements::apply_job(const AppendMoveJob& job) {
    const auto match = find_open(job.match);
    if (!match) return no_open_match(job.match);
    if (job.record.shot) execute(count_shot_, match->num);
    if (job.record.ruling && job.record.ruling->winner) {
        execute(count_game_, match->num);
        execute(count_win_, match->num, std::int32_t{job.record.ruling->winner->value});
    }
    append(*match, job.record);
    return std::nullopt;
}

JobFailure JobStatements::apply_job(const CloseMatchJob& job) {
    const auto match = find_open(job.match);
    if (!match) return no_open_match(job.match);
    execute(close_, job.record.at_ms, match->num);
    append(*match, job.record);
    return std::nullopt;
}

std::optional<JobStatements::OpenMatch> JobStatements::find_open(const std::string& id) {
    find_open_.reset();
    find_open_.bind(1, id);
    if (!find_open_.executeStep()) return std::nullopt;
    const auto last_n = static_cast<std::uint64_t>(find_open_.getColumn(1).getInt64());
    return OpenMatch{find_open_.getColumn(0).getInt64(), last_n + 1};
}

bool JobStatements::is_taken(const std::string& id, const std::string& code) {
    is_taken_.reset();
    SQLite::bind(is_taken_, id, code);
    return is_taken_.executeStep() && is_taken_.getColumn(0).getInt() > 0;
}

void JobStatements::append(const OpenMatch& match, const protocol::ReplayRecord& record) {
    const std::string body = protocol::to_text(match.next_n, record);
    assert(protocol::record_from_text(body).ok());
    execute(append_, match.num, static_cast<std::int64_t>(match.next_n),
            std::string(protocol::kind_of(record)), body, protocol::checksum_text(body));
}

}  // namespace poolhall::server
