// The slow reference on a thread of its own, so that a window answers while it draws.
// SPDX-License-Identifier: MIT
#pragma once

#include "lighting/reference/reference.hpp"
#include "render/renderer.hpp"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace lab {

/// Draws one frame at a time with Reference<double>, on all cores at a low priority: what else wants a core
/// goes first. All members are for one thread, the window's.
class ReferenceAside {
  public:
    /// `onChange` is called from the other thread when share() has grown and when a frame is finished or
    /// failed: to wake the window. It may call share(), busy() and take(), and must not throw; it is not
    /// called any more once this is destroyed.
    explicit ReferenceAside(std::function<void()> onChange = {});
    /// Ends what is under way and waits for it, some milliseconds.
    ~ReferenceAside();
    ReferenceAside(const ReferenceAside&) = delete;
    ReferenceAside& operator=(const ReferenceAside&) = delete;

    /// Begins a frame. All that counts of the scene is copied before this returns, some 3 ms for 50,000
    /// triangles: then it may change or go. The scene must be up to date and valid, its matrices too. A frame
    /// that is under way is given up and a finished one that was not taken is forgotten.
    void ask(const THREE::Scene& scene, const THREE::PerspectiveCamera& camera,
             const lighting::Settings& settings, const render::FrameRequest& request);
    /// Gives up what is under way, and forgets what was finished.
    void cancel();
    /// Whether a frame was asked for and is neither finished nor given up.
    bool busy() const;
    /// Of the last frame that was asked for: what is drawn of it, 0 to 1.
    double share() const;
    /// The frame of the last ask(), once; none as long as it is not finished. Rethrows what ended its
    /// drawing, once.
    std::optional<image::Frame> take();

  private:
    struct Job {
        lighting::reference::Reference<double> reference;
        bool floats;
    };
    void work();
    void draw(const Job& job);
    void changed() const {
        if (onChange_)
            onChange_();
    }

    const std::function<void()> onChange_;
    mutable std::mutex mutex_;  // of all below but stop_
    std::condition_variable asked_;
    std::optional<Job> next_;
    std::optional<image::Frame> frame_;
    std::exception_ptr failure_;
    double share_ = 0;
    bool drawing_ = false;
    bool leave_ = false;
    std::atomic<bool> stop_ = false;  // what is being drawn is not wanted any more; written under the mutex
    std::thread thread_;  // last: it uses all the others
};

}  // namespace lab
