"""Adapters: SMILE's demonstrator in other simulators. Each module needs the simulator that it is named after."""
