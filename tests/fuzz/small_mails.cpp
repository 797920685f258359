// Trims, user commands and answers as words of the EMI's window (msgclient/emi_window.hpp). Whatever the
// words: they are damaged, or they are exactly what the mail is packed into again; every verdict and reason
// has words for people.
#include <cstdint>
#include <span>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgclient/mails.hpp"
#include "msgclient/emi_window.hpp"

namespace gaitway::fuzz {
namespace {

template <class Mail>
bool check(std::span<const std::uint32_t> words, Mail& mail) {
  if (!msgclient::unpack(words, mail)) {
    return false;
  }
  const auto again = msgclient::pack(mail);
  require(std::equal(words.begin(), words.end(), again.begin(), again.end()),
          "what is accepted packs into the same words");
  return true;
}

}  // namespace

void small_mails(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const auto options = input.take<std::uint8_t>();
  std::vector<std::uint32_t> words;
  constexpr std::size_t kMost = 16;
  while (!input.empty() && words.size() < kMost) {
    words.push_back(input.take<std::uint32_t>());
  }
  if ((options & 1U) != 0 && !words.empty()) {
    words.back() = msgclient::crc32(std::span(words).first(words.size() - 1));
  }
  msgclient::TrimUpdate trim;
  if (check(words, trim)) {
    require(trim.channel_count <= kTrimChannels, "channels are in range");
  }
  msgclient::UserCommandMail command;
  check(words, command);
  msgclient::Answer answer;
  if (check(words, answer)) {
    require(!msgclient::reason_text(answer.reason).empty(), "every reason has a text");
    require(!msgclient::verdict_name(answer.verdict).empty(), "every verdict has a name");
  }
}

}  // namespace gaitway::fuzz
