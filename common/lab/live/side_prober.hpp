// The probe of a picture with one side or two: what is seen decides which scene and which switches a place is evaluated with.
// SPDX-License-Identifier: MIT
#pragma once

#include "lab/live/probe.hpp"
#include "lab/live/session.hpp"

#include <optional>

namespace lab {

class SideProber {
  public:
    /// Something has changed, and what is known of the scene with it.
    void changed() { changed_ = true; }
    /// The numbers of a place of a picture of this size, or, without a place, of the session's pinned point; none without either.
    /// `before`: the lesson before this one, if it is shown. The session must be up to date.
    std::optional<ProbeReport> look(Session& session, View* before, const std::optional<PanelPoint>& at,
                                    int width, int height);

  private:
    void see(const Side& side, int width, int height);

    Prober prober_;
    bool changed_ = true;
    int firstColumn_ = 0;  // of the side that the prober saw
};

}  // namespace lab
