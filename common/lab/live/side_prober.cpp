// Which side is probed.
// SPDX-License-Identifier: MIT
#include "lab/live/side_prober.hpp"

#include <algorithm>

namespace lab {

void SideProber::see(const Side& side, int width, int height) {
    if (!changed_ && side.firstColumn == firstColumn_)
        return;
    prober_.see(side.view->scene(), side.view->camera(), side.settings, width, height);
    changed_ = false;
    firstColumn_ = side.firstColumn;
}

std::optional<ProbeReport> SideProber::look(Session& session, View* before,
                                            const std::optional<PanelPoint>& at, int width, int height) {
    if (!at && !session.pin)
        return std::nullopt;
    const auto pixel = [](double share, int count) {
        return std::clamp(static_cast<int>(share * count), 0, count - 1);
    };
    const std::vector<Side> sides = session.sides(width, before);
    const auto ask = [&](const Side& side) {
        see(side, width, height);
        return at ? prober_.at(pixel(at->x, width), pixel(at->y, height)) : prober_.at(*session.pin);
    };
    const Side& first = sides.front();
    const bool inFirst = at && pixel(at->x, width) < first.endColumn;
    std::optional<ProbeReport> report = ask(inFirst ? first : sides.back());
    // A pinned point may be seen in the first side; there it is another lesson's, or this one's with other terms.
    if (!at && report && report->pixel && (*report->pixel)[0] < first.endColumn &&
        first.view == &session.view())
        report = ask(first);
    return report;
}

}  // namespace lab
