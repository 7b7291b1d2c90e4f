#pragma once

#include "client/desktop/app/options.hpp"
#include "client/desktop/app/screen.hpp"
#include "client/desktop/app/table_controller.hpp"
#include "client/desktop/audio/sounds.hpp"
#include "client/desktop/net/token_store.hpp"
#include "client/desktop/view/table_view.hpp"
#include "client/play/transport.hpp"

#include <memory>

namespace poolhall::client {

/// A match: its table, who plays, what is heard of it.
class TableScreen : public Screen {
  public:
    explicit TableScreen(const Options& options);

    Answer handle(const ScreenEvent& event) override;
    void update(double dt, double now) override;
    void draw(const Frame& frame) override;

    [[nodiscard]] bool moves() const override;
    [[nodiscard]] std::uint64_t revision() const override;
    [[nodiscard]] double due_in(double now) const override;
    [[nodiscard]] std::string title() const override;
    bool show_status(const std::string& line) override;

  private:
    [[nodiscard]] std::unique_ptr<ClientMatch> make_match(const Options& options);
    Answer act(Action action);
    Answer pointed(const ScreenEvent& event);
    void copy_code();
    void play_sounds();

    TableView view_;
    Sounds sounds_;
    TokenStore tokens_;
    Playback playback_;
    std::unique_ptr<Transport> transport_;
    std::unique_ptr<ClientMatch> match_;
    TableController controller_;
    Input input_;
    std::uint64_t sound_changes_ = 0;
};

}  // namespace poolhall::client
