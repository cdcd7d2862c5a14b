#include "sim_bridge/grpc/unknown_method.h"

#include <memory>

#include "sim_bridge/grpc/call_slot.h"

namespace seaway::bridge::rpc {

/// Goes when its refusal is sent.
class UnknownMethod::Call {
 public:
  Call(UnknownMethod& method, grpc::ServerCompletionQueue* queue)
      : method_(method), queue_(queue), stream_(&context_) {
    method_.host_.slotOpens();
    method_.service_.RequestCall(&context_, &stream_, queue, queue, &called_);
  }

 private:
  void called(bool ok) {
    if (!ok) return finished(false);
    if (!method_.host_.ending) method_.listen(queue_);
    method_.host_.meter.refused(Refusal::notFound);
    stream_.Finish({grpc::StatusCode::UNIMPLEMENTED,
                    context_.method().substr(0, mostTold) + ": there is no such method here"},
                   &finished_);
  }
  void finished(bool) {
    CallHost& host = method_.host_;
    delete this;
    host.slotCloses();
  }

  static constexpr std::size_t mostTold = 200;
  UnknownMethod& method_;
  grpc::ServerCompletionQueue* queue_;
  grpc::GenericServerContext context_;
  grpc::GenericServerAsyncReaderWriter stream_;
  Step<Call, &Call::called> called_{*this};
  Step<Call, &Call::finished> finished_{*this};
};

void UnknownMethod::listen(grpc::ServerCompletionQueue* queue) {
  new Call(*this, queue);  // its events hold it
}

}  // namespace seaway::bridge::rpc
