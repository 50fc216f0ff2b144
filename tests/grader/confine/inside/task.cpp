// Reads the job that came over the pipe.
// SPDX-License-Identifier: MIT
#include "grader/confine/inside/task.hpp"

namespace grader::inside {

Task readTask(std::string bytes) {
    wire::Reader in(std::move(bytes));
    Task task;
    task.namespaces = in.number() != 0;
    task.landlock = in.number() != 0;
    task.user = static_cast<std::int64_t>(in.number()) - 1;
    task.box = in.text();
    task.wallSeconds = static_cast<double>(in.number()) / 1000;
    task.cpuSeconds = in.number();
    task.memoryBytes = in.number();
    task.processes = in.number();
    task.fileBytes = in.number();
    task.folderBytes = in.number();
    task.files = in.number();
    task.command = in.list();
    task.environment = in.list();
    task.readable = in.list();
    task.wanted.resize(in.number());
    for (Wanted& wanted : task.wanted) {
        wanted.name = in.text();
        wanted.bytes = in.number();
        wanted.exactly = in.number() != 0;
    }
    return task;
}

}  // namespace grader::inside
