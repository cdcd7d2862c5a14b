#pragma once

#include "sim_bridge/grpc/rpc_method.h"

namespace seaway::bridge::rpc {

/// What asks a generated service for the next call of a method: its Request… member.
using ListenFeed = std::function<void(grpc::ServerContext*, grpc::ByteBuffer*,
                                      grpc::ServerAsyncWriter<grpc::ByteBuffer>*,
                                      grpc::ServerCompletionQueue*, void*)>;

/// A method of one request and answers for as long as the host likes: `Answerer` (see CallSlot) is
/// asked for the next one as soon as one is sent, says `again` while there is none, and ends the
/// call, the end of the service among its reasons, by throwing.
template <class Answerer>
class FeedMethod : public Method {
 public:
  FeedMethod(CallHost& host, ListenFeed ask, std::function<Answerer()> make)
      : host_(host), ask_(std::move(ask)), make_(std::move(make)) {}

  void listen(grpc::ServerCompletionQueue* queue) override {
    std::unique_ptr<Slot> slot = spare_.take();
    if (!slot) slot = std::make_unique<Slot>(*this);
    slot.release()->listen(queue);
  }

 private:
  class Slot : public CallSlot<Slot, Answerer> {
   public:
    explicit Slot(FeedMethod& method)
        : CallSlot<Slot, Answerer>(method.host_, method.make_()), method_(method) {}

    void listen(grpc::ServerCompletionQueue* queue) {
      grpc::ServerContext& context = this->renew(queue);
      writer_.emplace(&context);
      method_.ask_(&context, &this->received_, &*writer_, queue, &called_);
    }
    void sendAnswer() { writer_->Write(this->sent_, &written_); }
    void sendRefusal(const grpc::Status& status) { writer_->Finish(status, &this->statusSent_); }
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
    void written(bool ok) {
      if (!ok) return sendRefusal({grpc::StatusCode::CANCELLED, "the host has gone"});
      this->answer();
    }
    FeedMethod& method_;
    std::optional<grpc::ServerAsyncWriter<grpc::ByteBuffer>> writer_;
    Step<Slot, &Slot::called> called_{*this};
    Step<Slot, &Slot::written> written_{*this};
  };

  CallHost& host_;
  ListenFeed ask_;
  std::function<Answerer()> make_;
  SpareSlots<Slot> spare_;
};

}  // namespace seaway::bridge::rpc
