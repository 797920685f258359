// The paragraphs of docs/network.md that no table can give.
#pragma once

#include <string_view>

namespace gaitway::tools {

extern const std::string_view kHowTheNetworkWorks;
extern const std::string_view kHowToReadTheFields;
extern const std::string_view kThePaperProfile;
extern const std::string_view kWhereElse;

}  // namespace gaitway::tools
