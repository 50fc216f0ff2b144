// The table of keys.
// SPDX-License-Identifier: MIT
#include "lab/window/window_keys.hpp"

#include "lab/window.hpp"

#include <GLFW/glfw3.h>
#include <string_view>

namespace lab {

namespace {

constexpr struct {
    int glfw, code;
} named[] = {
    {GLFW_KEY_ESCAPE, keyEscape}, {GLFW_KEY_TAB, keyTab},        {GLFW_KEY_LEFT, keyLeft},
    {GLFW_KEY_RIGHT, keyRight},   {GLFW_KEY_PAGE_UP, keyPageUp}, {GLFW_KEY_PAGE_DOWN, keyPageDown},
    {GLFW_KEY_DELETE, keyDelete}, {GLFW_KEY_KP_ADD, '+'},        {GLFW_KEY_KP_SUBTRACT, '-'},
    {GLFW_KEY_KP_MULTIPLY, '*'},  {GLFW_KEY_KP_DIVIDE, '/'},     {GLFW_KEY_KP_DECIMAL, '.'},
    {GLFW_KEY_SPACE, ' '},
};

int upperCase(int character) {
    return character >= 'a' && character <= 'z' ? character - 'a' + 'A' : character;
}

}  // namespace

int keyCode(int glfwKey, int scancode) {
    for (const auto& [glfw, code] : named)
        if (glfwKey == glfw)
            return code;
    if (glfwKey >= GLFW_KEY_F1 && glfwKey <= GLFW_KEY_F12)
        return keyF1 + (glfwKey - GLFW_KEY_F1);
    if (glfwKey >= GLFW_KEY_KP_0 && glfwKey <= GLFW_KEY_KP_9)
        return '0' + (glfwKey - GLFW_KEY_KP_0);
    const char* const name = glfwGetKeyName(glfwKey, scancode);
    if (name != nullptr && name[0] > ' ' && name[0] < 0x7F && name[1] == '\0')
        return upperCase(name[0]);
    return glfwKey > ' ' && glfwKey < 0x7F ? upperCase(glfwKey)
                                           : 0;  // a letter that is not ASCII: by its place
}

bool keyRepeats(int code) {
    return code == keyLeft || code == keyRight || code == keyPageUp || code == keyPageDown || code == '+' ||
           code == '-';
}

bool typedMeans(unsigned character) {
    constexpr std::string_view meant = "+-*/=?,.<>[]";
    return character < 0x7F && meant.find(static_cast<char>(character)) != std::string_view::npos;
}

}  // namespace lab
