#include "client/lab/run/progress.hpp"

#include <csignal>
#include <iomanip>

namespace poolhall::lab {

namespace {

volatile std::sig_atomic_t interrupted = 0;

extern "C" void note_interrupt(int) {
    interrupted = 1;
}

}  // namespace

Interruption::Interruption() : before_(std::signal(SIGINT, note_interrupt)) {
    interrupted = 0;
}

Interruption::~Interruption() {
    std::signal(SIGINT, before_);
}

bool Interruption::asked_for() {
    return interrupted != 0;
}

void Progress::begin(const std::string& part, std::size_t steps) {
    part_ = part;
    steps_ = steps;
    done_ = 0;
    draw();
}

void Progress::step() {
    ++done_;
    if (done_ * 100 / steps_ != shown_) draw();
}

void Progress::clear() {
    if (visible_) out_ << "\r\033[K" << std::flush;
}

void Progress::draw() {
    constexpr std::size_t kWidth = 40;
    shown_ = done_ * 100 / steps_;
    if (!visible_) return;
    const std::size_t full = done_ * kWidth / steps_;
    out_ << "\r\033[K[" << std::string(full, '#') << std::string(kWidth - full, '.') << "] "
         << std::setw(3) << shown_ << " %  " << part_ << std::flush;
}

}  // namespace poolhall::lab
