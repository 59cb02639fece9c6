"""Plays the scale of 19_camera_and_scale.rob: answers W with a weight. Usage: scale.py [PORT]"""
import socket
import sys

listener = socket.create_server(("127.0.0.1", int(sys.argv[1]) if len(sys.argv) > 1 else 4001))
weight = 10.0
while True:
    connection, _ = listener.accept()
    with connection, connection.makefile("r") as lines:
        for line in lines:
            if line.strip() == "W":
                weight += 2.5
                connection.sendall(f"{weight:.1f} g\r\n".encode())
