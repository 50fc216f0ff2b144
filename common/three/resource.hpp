// What a Mesh refers to without owning it: geometries and materials, and how a mesh notices that one is gone.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace THREE {

/// Base of geometries and materials. On the stack, non-copyable; meshes see it through a Handle.
class Resource {
  public:
    Resource();
    virtual ~Resource() { *alive_ = false; }
    Resource(const Resource&) = delete;
    Resource& operator=(const Resource&) = delete;

    std::string name;  ///< for messages and JSON; may be empty
    /// Different for each resource of this process and never used again: what the renderer remembers uploads by.
    std::uint64_t id() const { return id_; }

  private:
    template <class T>
    friend class Handle;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
    std::uint64_t id_;
};

/// A reference to a resource that is either owned elsewhere (stack) or shared (loaders), and knows when the former
/// has been destroyed: get() is then null, and validate() says whose geometry or material it was.
template <class T>
class Handle {
  public:
    Handle() = default;
    Handle(T& resource) : alive_(resource.alive_), target_(&resource) {}
    Handle(std::shared_ptr<T> resource) : owner_(std::move(resource)) {
        if (owner_ != nullptr) {
            alive_ = owner_->alive_;
            target_ = owner_.get();
        }
    }
    template <class U>
    Handle(std::shared_ptr<U> resource) : Handle(std::shared_ptr<T>(std::move(resource))) {}
    /// The resource, or null if there never was one or it was destroyed.
    T* get() const { return alive_ != nullptr && *alive_ ? target_ : nullptr; }
    T* operator->() const { return get(); }
    T& operator*() const { return *get(); }
    explicit operator bool() const { return get() != nullptr; }

  private:
    std::shared_ptr<bool> alive_;
    std::shared_ptr<T> owner_;
    T* target_ = nullptr;
};

}  // namespace THREE
