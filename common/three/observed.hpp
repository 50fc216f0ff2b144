// A number that tells its owner when it is written: how Euler and Quaternion stay in step.
// SPDX-License-Identifier: MIT
#pragma once

namespace THREE {

/// Who wants to know that a component was written (three.js: _onChangeCallback).
class ChangeListener {
  public:
    virtual void changed() = 0;

  protected:
    ~ChangeListener() = default;
};

/// A double that reads and writes like one and tells its listener of each write, so that
/// `mesh.rotation.x += 0.1` reaches `mesh.quaternion` at once, as in three.js.
/// Copying copies the value only, never the listener.
class Observed {
  public:
    Observed(double value = 0) : value_(value) {}
    Observed(const Observed& other) : value_(other.value_) {}
    Observed& operator=(const Observed& other) { return *this = other.value_; }
    Observed& operator=(double value) {
        value_ = value;
        if (listener_ != nullptr)
            listener_->changed();
        return *this;
    }
    Observed& operator+=(double value) { return *this = value_ + value; }
    Observed& operator-=(double value) { return *this = value_ - value; }
    Observed& operator*=(double value) { return *this = value_ * value; }
    Observed& operator/=(double value) { return *this = value_ / value; }
    operator double() const { return value_; }

    /// Writes without telling anybody: for the owner, which would else be told of its own writes.
    void setSilently(double value) { value_ = value; }
    /// The one to tell from now on; null: nobody. The listener must outlive this number.
    void listen(ChangeListener* listener) { listener_ = listener; }

  private:
    double value_;
    ChangeListener* listener_ = nullptr;
};

}  // namespace THREE
