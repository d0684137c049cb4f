"""What an aircraft's folder says of it: actuators, limits, envelope, control design, and the stored design model."""
