"""A client that watches a twin, or the robot that it is of."""
import roslibpy

SEND = "gaitway_msgs/srv/SendToRobot"


class Client:
    """A client of a robot's API, with the newest message of some topics."""

    def __init__(self, port, topics):
        self.ros = roslibpy.Ros("127.0.0.1", port)
        self.ros.run(timeout=20)
        self.newest = {}
        self._topics = []  # kept: they end with their object
        for topic, kind in topics.items():
            one = roslibpy.Topic(self.ros, topic, kind)
            one.subscribe(lambda message, topic=topic: self.newest.__setitem__(topic, message))
            self._topics.append(one)

    def call(self, service, kind, **arguments):
        return dict(roslibpy.Service(self.ros, service, kind).call(roslibpy.ServiceRequest(arguments), timeout=20))

    def close(self):
        self.ros.close()
