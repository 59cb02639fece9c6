"""Plays the camera of 19_camera_and_scale.rob: answers LOOK with a place. Usage: camera.py [PORT]"""
import socket
import sys

places = [(60, 40), (100, 60), (140, 40)]
listener = socket.create_server(("127.0.0.1", int(sys.argv[1]) if len(sys.argv) > 1 else 4002))
while True:
    connection, _ = listener.accept()
    with connection, connection.makefile("r") as lines:
        for count, line in enumerate(lines):
            x, y = places[count % len(places)]
            connection.sendall(f"{x} {y}\n".encode())
