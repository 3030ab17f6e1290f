"""The client and the motion library for brains in Python."""
