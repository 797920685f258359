// The campaign as a picture: a bar for each row, cut into the ways in which its trials end.
#include <fmt/format.h>

#include "tools/campaign/campaign.hpp"
#include "tools/campaign/row_summary.hpp"
#include "tools/run/svg_plot.hpp"

namespace gaitway::tools {
namespace {

constexpr double kRow_px = 16.0, kBar_px = 12.0, kNames_px = 190.0, kBars_px = 520.0, kHead_px = 56.0;

std::string legend() {
  std::string svg;
  double x_px = kNames_px;
  for (const FaultEndLook& look : kFaultEndLooks) {
    svg += fmt::format(
        "<rect x=\"{:.0f}\" y=\"30\" width=\"10\" height=\"10\" fill=\"{}\"/>"
        "<text x=\"{:.0f}\" y=\"39\">{}</text>\n",
        x_px, look.colour, x_px + 14.0, escape_html(look.words));
    x_px += 30.0 + 6.0 * static_cast<double>(look.words.size());
  }
  return svg;
}

std::string bar(const CampaignRow& row, double y_px) {
  const RowSummary summary = summary_of(row);
  std::string svg =
      fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\" text-anchor=\"end\"><title>{}</title>{}</text>\n",
                  kNames_px - 8.0, y_px + 10.0, escape_html(row.row.what), escape_html(row.row.name));
  double x_px = kNames_px;
  for (std::size_t end = 0; end < kFaultEnds && summary.trials > 0; ++end) {
    if (summary.ends[end] == 0) continue;
    const double width_px =
        kBars_px * static_cast<double>(summary.ends[end]) / static_cast<double>(summary.trials);
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\" fill=\"{}\">"
        "<title>{} of {}: {}</title></rect>\n",
        x_px, y_px, width_px, kBar_px, kFaultEndLooks[end].colour, summary.ends[end], summary.trials,
        escape_html(kFaultEndLooks[end].words));
    x_px += width_px;
  }
  return svg + fmt::format("<text x=\"{:.0f}\" y=\"{:.1f}\">{} of {} fall</text>\n",
                           kNames_px + kBars_px + 8.0, y_px + 10.0, row.falls(), summary.trials);
}

}  // namespace

std::string campaign_picture(const CampaignHead& head, const Campaign& campaign) {
  const double width_px = kNames_px + kBars_px + 110.0;
  const double height_px = kHead_px + kRow_px * static_cast<double>(campaign.rows.size()) + 8.0;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
      "height=\"{1:.0f}\" font-family=\"sans-serif\" font-size=\"11\" fill=\"#222\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"{2:.0f}\" y=\"18\" font-size=\"13\">What becomes of faults at random instants of a walk at "
      "{3} "
      "m/s</text>\n",
      width_px, height_px, kNames_px, head.options.speed_m_per_s);
  svg += legend();
  double y_px = kHead_px;
  for (const CampaignRow& row : campaign.rows) {
    svg += bar(row, y_px);
    y_px += kRow_px;
  }
  return svg + "</svg>\n";
}

}  // namespace gaitway::tools
