// The parts of Asio and Beast that need no template are compiled here, once, and nowhere else.

#include <boost/asio/impl/src.hpp>
#include <boost/asio/ssl/impl/src.hpp>
#include <boost/beast/src.hpp>
