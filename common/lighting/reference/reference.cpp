// The reference in its three usual scalars, and the threads it runs on.
// SPDX-License-Identifier: MIT
#include "lighting/reference/raster.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace lighting::reference {

void onAllCores(int count, const std::function<void(int)>& work) {
    std::atomic<int> next = 0;
    std::exception_ptr failure;
    std::mutex failing;
    const auto loop = [&] {
        try {
            for (int i = next++; i < count; i = next++)
                work(i);
        } catch (...) {
            const std::lock_guard<std::mutex> lock(failing);
            failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::thread> others;
    const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, count);
    for (int i = 1; i < threads; ++i)
        others.emplace_back(loop);
    loop();
    for (std::thread& thread : others)
        thread.join();
    if (failure)
        std::rethrow_exception(failure);
}

template class Reference<float>;
template class Reference<double>;
template class Reference<long double>;

}  // namespace lighting::reference
