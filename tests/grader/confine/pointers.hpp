// Words as exec wants them.
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace grader {

/// Points into `words`, which must stay as they are; a null pointer at the end.
inline std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> list;
    for (std::string& word : words) {
        list.push_back(word.data());
    }
    list.push_back(nullptr);
    return list;
}

}  // namespace grader
