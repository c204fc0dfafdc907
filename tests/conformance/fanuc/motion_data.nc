(SOURCE B-64154EN/01 p. 53 and B-63980EN/01 pp. 99 and 100; expected times are closed forms)

(CASE an axis that lags by 2.92 mm when its command stands: in-position width and NCI)
(SHEET [machine.axes.X])
(SHEET servo_gain = 1.0)
(SHEET acceleration = 1000.0)
(SHEET rapid = 6000.0)
#3001=0
G0X100.
#100=#3001
G4X3.
G10L50
N1826P1R5
G11
#3001=0
G0X0
#101=#3001
G4X3.
G10L52
N1601R00100000
G11
#3001=0
G0X100.
#102=#3001
G4X3.
#3001=0
G61G1X0F6000
#103=#3001
M30
(EXPECT #100 = 1440 WITHIN 1)
(EXPECT #101 = 1482 WITHIN 1)
(EXPECT #102 = 1100 WITHIN 1)
(EXPECT #103 = 1100 WITHIN 1)
