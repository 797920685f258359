// Random ids and the comparison of tokens.
#pragma once

#include <string>
#include <string_view>

namespace gaitway::api {

// 32 hexadecimal digits that nobody can foresee. Throws std::system_error when the system gives no random
// bytes.
[[nodiscard]] std::string random_id();

// Takes the same time whatever differs, also when the lengths do.
[[nodiscard]] bool same_secret(std::string_view a, std::string_view b) noexcept;

}  // namespace gaitway::api
