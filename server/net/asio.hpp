#pragma once

// The Asio types of the server, concrete throughout: a type-erased executor or stream costs an
// indirect call and often an allocation at every operation. Include this in few .cpp files only.

#include <boost/asio/as_tuple.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/basic_socket_acceptor.hpp>
#include <boost/asio/basic_stream_socket.hpp>
#include <boost/asio/basic_waitable_timer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/use_awaitable.hpp>

#include <chrono>
#include <memory>
#include <utility>

namespace poolhall::server::net {

using namespace boost::asio;
using boost::system::error_code;

using Executor = io_context::executor_type;
using Socket = basic_stream_socket<ip::tcp, Executor>;
using Acceptor = basic_socket_acceptor<ip::tcp, Executor>;
using Timer = basic_waitable_timer<std::chrono::steady_clock,
                                   wait_traits<std::chrono::steady_clock>, Executor>;
template <class T>
using Async = awaitable<T, Executor>;

/// co_await an operation for its error code and result, without exceptions.
inline constexpr as_tuple_t<use_awaitable_t<Executor>> kAwait{};

/// co_await something that answers by a callback: `start` is given a function to be called once
/// with the answer, on the coroutine's own loop.
template <class T, class Start>
Async<T> await_callback(Start start) {
    const auto initiate = [start = std::move(start)](auto handler) {
        const auto shared = std::make_shared<decltype(handler)>(std::move(handler));
        start([shared](T answer) { std::move (*shared)(std::move(answer)); });
    };
    use_awaitable_t<Executor> token;
    co_return co_await async_initiate<use_awaitable_t<Executor>, void(T)>(initiate, token);
}

}  // namespace poolhall::server::net
