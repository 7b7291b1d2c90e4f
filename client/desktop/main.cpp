#include "client/desktop/app/app.hpp"

#include <exception>
#include <iostream>

int main(int argc, char** argv) {
    using namespace poolhall::client;
    const auto options = parse_options(argc, argv);
    if (!options.ok()) {
        const EarlyExit& exit = options.error();
        (exit.status == 0 ? std::cout : std::cerr) << exit.text << '\n';
        return exit.status;
    }
    try {
        App(*options).run();
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "poolhall-client: " << error.what() << '\n';
        return 1;
    }
}
