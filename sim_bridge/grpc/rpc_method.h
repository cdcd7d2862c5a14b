#pragma once

#include <grpcpp/support/async_stream.h>
#include <grpcpp/support/async_unary_call.h>

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "sim_bridge/grpc/call_slot.h"

namespace seaway::bridge::rpc {

/// A method of a service: listens for calls, and keeps the slots that have answered some.
class Method {
 public:
  virtual ~Method() = default;
  /// Listens for one more call, on the thread behind `queue`.
  virtual void listen(grpc::ServerCompletionQueue* queue) = 0;
};

/// Slots that wait to be used again.
template <class Slot>
class SpareSlots {
 public:
  std::unique_ptr<Slot> take() {
    const std::lock_guard lock(mutex_);
    if (spare_.empty()) return nullptr;
    std::unique_ptr<Slot> slot = std::move(spare_.back());
    spare_.pop_back();
    return slot;
  }
  void give(std::unique_ptr<Slot> slot) {
    if (slot->isBloated()) return;
    const std::lock_guard lock(mutex_);
    if (spare_.size() < mostKept) spare_.push_back(std::move(slot));
  }

 private:
  static constexpr std::size_t mostKept = 64;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Slot>> spare_;
};

/// What asks a generated service for the next call of a method: its Request… member.
using ListenUnary = std::function<void(grpc::ServerContext*, grpc::ByteBuffer*,
                                       grpc::ServerAsyncResponseWriter<grpc::ByteBuffer>*,
                                       grpc::ServerCompletionQueue*, void*)>;
using ListenStream = std::function<void(
    grpc::ServerContext*, grpc::ServerAsyncReaderWriter<grpc::ByteBuffer, grpc::ByteBuffer>*,
    grpc::ServerCompletionQueue*, void*)>;

/// A method of one request and one answer. `Answerer`: see CallSlot.
template <class Answerer>
class UnaryMethod : public Method {
 public:
  UnaryMethod(CallHost& host, ListenUnary ask, std::function<Answerer()> make)
      : host_(host), ask_(std::move(ask)), make_(std::move(make)) {}

  void listen(grpc::ServerCompletionQueue* queue) override {
    std::unique_ptr<Slot> slot = spare_.take();
    if (!slot) slot = std::make_unique<Slot>(*this);
    slot.release()->listen(queue);
  }

 private:
  class Slot : public CallSlot<Slot, Answerer> {
   public:
    explicit Slot(UnaryMethod& method)
        : CallSlot<Slot, Answerer>(method.host_, method.make_()), method_(method) {}

    void listen(grpc::ServerCompletionQueue* queue) {
      grpc::ServerContext& context = this->renew(queue);
      writer_.emplace(&context);
      method_.ask_(&context, &this->received_, &*writer_, queue, &called_);
    }
    void sendAnswer() { writer_->Finish(this->sent_, grpc::Status::OK, &this->statusSent_); }
    void sendRefusal(const grpc::Status& status) {
      writer_->FinishWithError(status, &this->statusSent_);
    }
    void retire() { method_.spare_.give(std::unique_ptr<Slot>(this)); }

   private:
    void called(bool ok) {
      if (!ok) {
        const std::unique_ptr<Slot> gone(this);
        return this->neverBegan();
      }
      if (!this->host_.ending) method_.listen(this->queue_);
      if (this->begins()) this->take();
    }
    UnaryMethod& method_;
    std::optional<grpc::ServerAsyncResponseWriter<grpc::ByteBuffer>> writer_;
    Step<Slot, &Slot::called> called_{*this};
  };

  CallHost& host_;
  ListenUnary ask_;
  std::function<Answerer()> make_;
  SpareSlots<Slot> spare_;
};

/// A method on which requests and answers take turns for as long as the host likes.
template <class Answerer>
class StreamMethod : public Method {
 public:
  StreamMethod(CallHost& host, ListenStream ask, std::function<Answerer()> make)
      : host_(host), ask_(std::move(ask)), make_(std::move(make)) {}

  void listen(grpc::ServerCompletionQueue* queue) override {
    std::unique_ptr<Slot> slot = spare_.take();
    if (!slot) slot = std::make_unique<Slot>(*this);
    slot.release()->listen(queue);
  }

 private:
  class Slot : public CallSlot<Slot, Answerer> {
   public:
    explicit Slot(StreamMethod& method)
        : CallSlot<Slot, Answerer>(method.host_, method.make_()), method_(method) {}

    void listen(grpc::ServerCompletionQueue* queue) {
      grpc::ServerContext& context = this->renew(queue);
      stream_.emplace(&context);
      method_.ask_(&context, &*stream_, queue, &called_);
    }
    void sendAnswer() { stream_->Write(this->sent_, &written_); }
    void sendRefusal(const grpc::Status& status) { stream_->Finish(status, &this->statusSent_); }
    void retire() { method_.spare_.give(std::unique_ptr<Slot>(this)); }

   private:
    void called(bool ok) {
      if (!ok) {
        const std::unique_ptr<Slot> gone(this);
        return this->neverBegan();
      }
      if (!this->host_.ending) method_.listen(this->queue_);
      if (this->begins()) next();
    }
    void next() { stream_->Read(&this->received_, &read_); }
    void read(bool ok) {
      if (ok) return this->take();
      sendRefusal(grpc::Status::OK);  // the host has said all
    }
    void written(bool ok) {
      if (!ok) return sendRefusal({grpc::StatusCode::CANCELLED, "the host has gone"});
      if (this->host_.ending) {
        return sendRefusal({grpc::StatusCode::UNAVAILABLE, "the service is ending"});
      }
      next();
    }
    StreamMethod& method_;
    std::optional<grpc::ServerAsyncReaderWriter<grpc::ByteBuffer, grpc::ByteBuffer>> stream_;
    Step<Slot, &Slot::called> called_{*this};
    Step<Slot, &Slot::read> read_{*this};
    Step<Slot, &Slot::written> written_{*this};
  };

  CallHost& host_;
  ListenStream ask_;
  std::function<Answerer()> make_;
  SpareSlots<Slot> spare_;
};

}  // namespace seaway::bridge::rpc
