// In place of the balance feedback: its last corrections fade to zero, its last trims to what its last gains
// make of the estimate (the law by which the message controller balances in a safe tail), or to zero, too.
// The gains stay: the message controller goes on with them.
#pragma once

#include <array>

#include "gaitway/manager/fallback.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgclient/trim_law.hpp"

namespace gaitway::core {

class TrimFallback final : public Fallback {
 public:
  static constexpr std::int64_t kRamp_ns = 300'000'000;

  TrimFallback(msgclient::Client& client, bool with_gains)
      : with_gains_(with_gains),
        trim_reader_(client.read<TrimCommand>("trim")),
        estimate_reader_(client.read<Estimate>("estimate")),
        correction_reader_(client.read<Correction>("correction")) {}

  void follow(const Tick&) noexcept override { acting_ = false; }
  bool act(const Tick& tick, ManagedPlugin& through) noexcept override;

 private:
  void begin(const Tick& tick) noexcept;
  void update_law(const Tick& tick) noexcept;

  bool with_gains_;
  msgclient::Reader<TrimCommand> trim_reader_;
  msgclient::Reader<Estimate> estimate_reader_;
  msgclient::Reader<Correction> correction_reader_;
  bool acting_ = false;
  std::int64_t begin_ns_ = 0;  // of the last tick in which the plug-in worked
  TrimCommand last_trim_{};
  msgclient::TrimGains gains_;
  std::array<double, kTrimChannels> law_rad_{};
  Estimate estimate_{};
  Correction last_correction_{};
};

}  // namespace gaitway::core
