// Calls home.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"
#include <sys/socket.h>

int main() {
    refused("socket", ::socket(AF_INET, SOCK_STREAM, 0));
    refused("socket", ::socket(AF_INET6, SOCK_DGRAM, 0));
    refused("socket", ::socket(AF_NETLINK, SOCK_RAW, 0));
    refused("socket", ::socket(AF_UNIX, SOCK_STREAM, 0));
    refused("socket", ::socket(AF_PACKET, SOCK_RAW, 0));
}
