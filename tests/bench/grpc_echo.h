#pragma once

#include <grpcpp/generic/async_generic_service.h>
#include <grpcpp/grpcpp.h>

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

/// The floor under any gRPC service: gRPC's C++ library alone, by its barest interface. Whatever is
/// called answers a prepared message, at once, on a few threads, each with a queue of its own.
class EchoServer {
 public:
  EchoServer(const std::string& address, const std::string& answer, int threads = 1) {
    const grpc::Slice slice(answer);
    answer_ = grpc::ByteBuffer(&slice, 1);
    grpc::ServerBuilder builder;
    builder.AddChannelArgument(GRPC_ARG_HTTP2_BDP_PROBE, 0);
    builder.AddListeningPort(address, grpc::InsecureServerCredentials(), &port_);
    builder.RegisterAsyncGenericService(&service_);
    for (int i = 0; i < threads; ++i) queues_.push_back(builder.AddCompletionQueue());
    server_ = builder.BuildAndStart();
    for (const auto& queue : queues_) {
      (new Call(*this, *queue))->listen();
      threads_.emplace_back([&queue = *queue] {
        void* tag = nullptr;
        for (bool ok = false; queue.Next(&tag, &ok);) static_cast<Call*>(tag)->goOn(ok);
      });
    }
  }
  ~EchoServer() {
    ending_ = true;
    server_->Shutdown(std::chrono::system_clock::now());
    for (const auto& queue : queues_) queue->Shutdown();
    for (std::thread& thread : threads_) thread.join();
  }
  int port() const { return port_; }

 private:
  class Call {
   public:
    Call(EchoServer& server, grpc::ServerCompletionQueue& queue)
        : server_(server), queue_(queue), stream_(&context_) {}
    void listen() { server_.service_.RequestCall(&context_, &stream_, &queue_, &queue_, this); }
    void goOn(bool ok) {
      switch (next_) {
        case Next::called:
          if (!ok) return delete this;
          if (!server_.ending_) (new Call(server_, queue_))->listen();
          return read();
        case Next::read:
          if (!ok) return finish();
          next_ = Next::written;
          // Nobody who calls once is sent an answer and a status apart.
          if (context_.method().ends_with("/Sample")) {
            next_ = Next::finished;
            return stream_.WriteAndFinish(server_.answer_, {}, grpc::Status::OK, this);
          }
          return stream_.Write(server_.answer_, this);
        case Next::written:
          return ok ? read() : finish();
        case Next::finished:
          delete this;
      }
    }

   private:
    enum class Next { called, read, written, finished } next_ = Next::called;
    void read() {
      next_ = Next::read;
      stream_.Read(&request_, this);
    }
    void finish() {
      if (server_.ending_) return delete this;  // its queue takes nothing more
      next_ = Next::finished;
      stream_.Finish(grpc::Status::OK, this);
    }
    EchoServer& server_;
    grpc::ServerCompletionQueue& queue_;
    grpc::GenericServerContext context_;
    grpc::GenericServerAsyncReaderWriter stream_;
    grpc::ByteBuffer request_;
  };

  grpc::AsyncGenericService service_;
  grpc::ByteBuffer answer_;
  std::vector<std::unique_ptr<grpc::ServerCompletionQueue>> queues_;
  std::unique_ptr<grpc::Server> server_;
  std::atomic<bool> ending_{false};
  int port_ = 0;
  std::vector<std::thread> threads_;
};
